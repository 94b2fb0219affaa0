#include "optimize/landmark_search.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

namespace glide {
namespace {

using test::DriftedMap;
using test::lookAlong;

constexpr int kMaxDistance = 64;

CameraModel lens() { return test::syntheticCamera(DistortionModel::radial_tangential); }

test::SyntheticCloudOptions wall() {
  test::SyntheticCloudOptions options;
  options.low = Vec3d(-4.0, -2.5, 3.0);
  options.high = Vec3d(6.0, 2.5, 5.0);
  options.noise_px = 0.5;
  options.flipped_bits = 15;
  return options;
}

/// A map of four keyframes and a frame between them.
struct MapAndFrame {
  MapAndFrame() : map(wall(), lens(), test::Drift::Zero()), cloud(lens(), wall()) {
    for (int k = 0; k < 4; ++k) map.add(lookAlong(Vec3d(0.3 * k, 0.0, 0.0), 0.0));
    snapshot = map.snapshot();
    for (const auto& landmark : snapshot->landmarks()) landmarks.push_back(&landmark);
    view = cloud.look(lookAlong(Vec3d(0.5, 0.1, 0.1), 0.05));
  }

  int extend(const SE3d& T_cam_world, double radius_px) {
    return search.extend(
        landmarks, *view.features, {T_cam_world, radius_px, kMaxDistance}, &matches);
  }
  int rightMatches() const {
    int right = 0;
    for (std::size_t i = 0; i < matches.of_feature.size(); ++i) {
      const auto* landmark = matches.of_feature[i];
      right += landmark != nullptr && map.cornerOf(*landmark) == view.points[i] ? 1 : 0;
    }
    return right;
  }

  DriftedMap map;
  test::SyntheticCloud cloud;
  std::shared_ptr<const MapSnapshot> snapshot;
  std::vector<const MapSnapshot::LandmarkEntry*> landmarks;
  test::SyntheticView view;
  LandmarkSearch search{Config{}, lens()};
  LandmarkMatches matches;
};

TEST(LandmarkSearch, FindsTheLandmarksInView) {
  MapAndFrame frame;
  const int in_view = frame.extend(frame.view.T_cam_world, 7.0);
  EXPECT_GT(in_view, 200);
  EXPECT_LT(in_view, static_cast<int>(frame.landmarks.size()) + 1);
  EXPECT_EQ(frame.search.visible().size(), static_cast<std::size_t>(in_view));
  EXPECT_GT(frame.matches.count, 0.8 * in_view);  // one in ten is not detected
  EXPECT_EQ(frame.rightMatches(), frame.matches.count);
}

TEST(LandmarkSearch, FindsNoLandmarkTwice) {
  MapAndFrame frame;
  frame.extend(frame.view.T_cam_world, 7.0);
  const int first = frame.matches.count;
  frame.extend(frame.view.T_cam_world, 7.0);
  EXPECT_EQ(frame.matches.count, first);
  frame.search.beginFrame();
  EXPECT_TRUE(frame.search.visible().empty());
}

TEST(LandmarkSearch, FindsNothingBehindTheCamera) {
  MapAndFrame frame;
  EXPECT_EQ(frame.extend(lookAlong(Vec3d(0.5, 0.1, 0.1), 3.14), 7.0), 0);
  EXPECT_EQ(frame.matches.count, 0);
}

TEST(LandmarkSearch, FindsNothingFromBehindTheLandmarks) {
  MapAndFrame frame;
  EXPECT_EQ(frame.extend(lookAlong(Vec3d(0.5, 0.0, 9.0), 3.14), 7.0), 0);
}

TEST(LandmarkSearch, RefinesAGuessAndTakesWrongMatchesBack) {
  MapAndFrame frame;
  std::mt19937_64 random(2);
  const SE3d T_guess = test::perturbed(frame.view.T_cam_world, 0.02, 0.004, &random);
  frame.extend(T_guess, 25.0);
  std::vector<std::size_t> matched;
  for (std::size_t i = 0; i < frame.matches.of_feature.size(); ++i)
    if (frame.matches.of_feature[i] != nullptr) matched.push_back(i);
  ASSERT_GT(matched.size(), 100U);
  std::swap(frame.matches.of_feature[matched[3]], frame.matches.of_feature[matched[50]]);
  const PoseEstimate pose = frame.search.refine(T_guess, *frame.view.features, &frame.matches);
  ASSERT_TRUE(pose.valid);
  EXPECT_LT(test::translationError(pose.T_cam_world, frame.view.T_cam_world), 0.005);
  EXPECT_EQ(frame.matches.of_feature[matched[3]], nullptr);
  EXPECT_EQ(frame.matches.of_feature[matched[50]], nullptr);
  EXPECT_EQ(frame.matches.count, pose.inliers);
}

TEST(LandmarkSearch, ReportsAPoseThatNothingHolds) {
  MapAndFrame frame;
  EXPECT_FALSE(frame.search.refine(SE3d{}, *frame.view.features, &frame.matches).valid);
}

}  // namespace
}  // namespace glide
