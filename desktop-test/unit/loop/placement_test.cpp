#include "loop/placement.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace glide {
namespace {

using test::DriftedMap;
using test::lookAlong;

CameraModel lens() { return test::syntheticCamera(DistortionModel::kannala_brandt4); }

test::SyntheticCloudOptions wall() {
  test::SyntheticCloudOptions options;
  options.low = Vec3d(-4.0, -2.5, 3.0);
  options.high = Vec3d(6.0, 2.5, 5.0);
  options.noise_px = 0.5;
  options.flipped_bits = 15;
  return options;
}

/// A map, and a frame in the midst of it.
struct LostFrame {
  LostFrame() : map(wall(), lens(), test::Drift::Zero()), cloud(lens(), wall()) {
    for (int k = 0; k < 6; ++k) map.add(lookAlong(Vec3d(0.4 * k, 0.0, 0.0), 0.0));
    snapshot = map.snapshot();
    view = cloud.look(lookAlong(Vec3d(1.0, 0.1, 0.2), 0.05));
  }

  /// A pose that `seen` landmarks of keyframe 2 suggest.
  PoseSuggestion suggestion(const SE3d& T_cam_world, std::size_t seen) const {
    PoseSuggestion result{T_cam_world, {}};
    for (const LandmarkId id : snapshot->keyframe(KeyframeId{2})->landmarks)
      if (id != kNoLandmark && result.seen.size() < seen) result.seen.push_back(id);
    return result;
  }
  std::optional<Placement> widened(const PoseSuggestion& suggestion) const {
    return widen(Config{}, lens(), *snapshot, *view.features, suggestion);
  }

  DriftedMap map;
  test::SyntheticCloud cloud;
  std::shared_ptr<const MapSnapshot> snapshot;
  test::SyntheticView view;
};

TEST(Placement, WidensAHandfulOfMatchesToAllLandmarksInView) {
  const LostFrame lost;
  std::mt19937_64 random(1);
  const SE3d T_near = test::perturbed(lost.view.T_cam_world, 0.02, 0.005, &random);
  const auto placement = lost.widened(lost.suggestion(T_near, 12));
  ASSERT_TRUE(placement);
  EXPECT_GT(placement->inliers, 150);
  EXPECT_GT(placement->inliers, 0.9 * placement->matched);
  EXPECT_GT(placement->inliers, 0.6 * placement->likely);
  EXPECT_GT(placement->cells, 25);
  EXPECT_NEAR(placement->median_depth, 4.5, 1.0);
  EXPECT_LT(test::translationError(placement->T_cam_world, lost.view.T_cam_world), 0.01);
}

TEST(Placement, KnowsHowCertainItsPositionIs) {
  const LostFrame lost;
  const auto placement = lost.widened(lost.suggestion(lost.view.T_cam_world, 12));
  ASSERT_TRUE(placement);
  const Vec3d error = placement->T_cam_world.inverse().t - lost.view.T_cam_world.inverse().t;
  const double sigma = placement->position_sigma * placement->median_depth;
  EXPECT_LT(error.norm(), 5.0 * sigma);
  EXPECT_GT(error.norm(), 0.05 * sigma);
}

TEST(Placement, ShowsThatAWrongPoseIsWrong) {
  const LostFrame lost;
  const SE3d T_wrong = lookAlong(Vec3d(3.0, 0.4, 0.0), 0.0);
  const auto placement = lost.widened(lost.suggestion(T_wrong, 12));
  if (!placement) return;  // the optimisation found nothing to hold on to: as good
  EXPECT_LT(placement->inliers, 30);
}

TEST(Placement, NeedsLandmarks) {
  const LostFrame lost;
  EXPECT_FALSE(lost.widened({lost.view.T_cam_world, {}}));
  EXPECT_FALSE(lost.widened({lost.view.T_cam_world, {LandmarkId{987654}}}));
}

TEST(Placement, IsTheSameUpToItsErrors) {
  Placement a;
  a.T_cam_world = lookAlong(Vec3d(1.0, 2.0, 3.0), 0.3);
  a.median_depth = 4.0;
  EXPECT_TRUE(areSame(a, a.T_cam_world));
  EXPECT_TRUE(areSame(a, lookAlong(Vec3d(1.1, 2.0, 3.0), 0.32)));
  EXPECT_FALSE(areSame(a, lookAlong(Vec3d(1.3, 2.0, 3.0), 0.3)));
  EXPECT_FALSE(areSame(a, lookAlong(Vec3d(1.0, 2.0, 3.0), 0.4)));
}

}  // namespace
}  // namespace glide
