#include "optimize/global_adjustment.h"

#include "support/true_map.h"

#include "map/map_correction.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>

namespace glide {
namespace {

test::SyntheticCloudOptions cloud(double noise_px) {
  test::SyntheticCloudOptions options;
  options.points = 500;
  options.noise_px = noise_px;
  return options;
}

/// A walk of eight keyframes past a cloud.
class GlobalAdjustmentTest : public testing::Test {
 protected:
  static test::TrueMap walked(double noise_px) {
    test::TrueMap world(cloud(noise_px));
    for (int i = 0; i < 8; ++i) world.addKeyframe(test::lookAlong(Vec3d(0.4 * i, 0.0, 0.0), 0.0));
    return world;
  }

  std::optional<GlobalAdjustment> adjust(const test::TrueMap& world) const {
    return adjustGlobally(world.cloud.camera(), *world.snapshot(), options_);
  }

  static Vec3d centerOf(const SE3d& T_cam_world) { return T_cam_world.inverse().t; }

  /// Mean distance of the keyframes from the first.
  static double spreadOf(const Map& map) {
    double sum = 0.0;
    const Vec3d first = centerOf(map.keyframes().begin()->second.T_cam_world);
    for (const auto& [id, keyframe] : map.keyframes()) {
      sum += (centerOf(keyframe.T_cam_world) - first).norm();
    }
    return sum / static_cast<double>(map.keyframes().size());
  }

  /// The largest distance of a keyframe from the truth. The first stands still, and the scale is
  /// whatever the map had: it is taken out.
  static double worstCenterError(const test::TrueMap& world) {
    test::TrueMap truth = world;
    truth.bend(0.0, 1.0);
    const double scale = spreadOf(truth.map) / spreadOf(world.map);
    const Vec3d first = centerOf(world.truePose(KeyframeId{0}));
    double worst = 0.0;
    for (const auto& [id, keyframe] : world.map.keyframes()) {
      const Vec3d center = first + scale * (centerOf(keyframe.T_cam_world) - first);
      worst = std::max(worst, (center - centerOf(world.truePose(id))).norm());
    }
    return worst;
  }

  /// Neighbouring landmarks of a keyframe swap their features there; how many pairs did.
  static int swapPairs(test::TrueMap* world, KeyframeId id) {
    std::vector<Observation> seen;
    std::vector<LandmarkId> landmarks;
    const std::vector<LandmarkId> slots = world->map.keyframe(id)->landmarks;
    for (std::size_t i = 0; i < slots.size() && seen.size() < 20; ++i) {
      if (slots[i] == kNoLandmark) continue;
      if (world->map.landmark(slots[i])->observations.size() < 4) continue;
      seen.push_back({id, static_cast<int>(i)});
      landmarks.push_back(slots[i]);
    }
    for (std::size_t i = 0; i + 1 < seen.size(); i += 2) {
      world->map.removeObservation(landmarks[i], id);
      world->map.removeObservation(landmarks[i + 1], id);
      world->map.addObservation(landmarks[i], seen[i + 1]);
      world->map.addObservation(landmarks[i + 1], seen[i]);
    }
    return static_cast<int>(seen.size() / 2);
  }

  const GlobalAdjustmentOptions options_{ScaleLevels(1.2, 8)};
};

TEST_F(GlobalAdjustmentTest, RecoversADisturbedMap) {
  test::TrueMap world = walked(0.0);
  world.disturb(0.01, 1);
  const double before = worstCenterError(world);
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  applyAdjustment(*adjustment, &world.map);
  EXPECT_GT(before, 0.005);
  EXPECT_LT(worstCenterError(world), 1e-5);
}

TEST_F(GlobalAdjustmentTest, StraightensABentMapWithNoisyCorners) {
  test::TrueMap world = walked(0.5);
  world.bend(0.1, 2.0);
  const double before = worstCenterError(world);
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  applyAdjustment(*adjustment, &world.map);
  EXPECT_GT(before, 0.05);
  EXPECT_LT(worstCenterError(world), 0.01);
}

TEST_F(GlobalAdjustmentTest, KeepsTheOldestKeyframeAndTheScale) {
  test::TrueMap world = walked(0.0);
  world.disturb(0.02, 2);
  const double before = spreadOf(world.map);
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  applyAdjustment(*adjustment, &world.map);
  const SE3d& T_first = world.map.keyframe(KeyframeId{0})->T_cam_world;
  EXPECT_LT(test::translationError(T_first, world.truePose(KeyframeId{0})), 1e-12);
  EXPECT_LT(test::rotationError(T_first, world.truePose(KeyframeId{0})), 1e-12);
  EXPECT_NEAR(spreadOf(world.map), before, 1e-9 * before);
}

TEST_F(GlobalAdjustmentTest, NamesEveryKeyframeAndLandmarkInOrder) {
  test::TrueMap world = walked(0.0);
  world.map.retireKeyframe(KeyframeId{3});
  const auto snapshot = world.snapshot();
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  ASSERT_EQ(adjustment->keyframes.size(), snapshot->keyframes().size());
  ASSERT_EQ(adjustment->landmarks.size(), snapshot->landmarks().size());
  for (std::size_t i = 0; i < adjustment->keyframes.size(); ++i) {
    EXPECT_EQ(adjustment->keyframes[i].id, snapshot->keyframes()[i].id);
  }
  for (std::size_t i = 0; i < adjustment->landmarks.size(); ++i) {
    EXPECT_EQ(adjustment->landmarks[i].id, snapshot->landmarks()[i].id);
  }
}

TEST_F(GlobalAdjustmentTest, TellsHowMuchTheSurroundingsOfAKeyframeGrew) {
  test::SyntheticCloudOptions options = cloud(0.0);
  options.points = 1200;
  options.high.x() = 20.0;
  test::TrueMap world(options);
  for (int i = 0; i < 8; ++i) world.addKeyframe(test::lookAlong(Vec3d(1.5 * i, 0.0, 0.0), 0.0));
  // The far half of the walk believes in a unit that is a twentieth shorter.
  const Vec3d about(5.0, 0.0, 3.0);
  const Sim3d S_grown{Eigen::Quaterniond::Identity(), -0.05 * about, 1.05};
  LoopCorrection drift;
  for (std::uint64_t i = 0; i < 8; ++i) {
    drift.keyframes.push_back({KeyframeId{i}, i < 4 ? Sim3d{} : S_grown});
  }
  applyCorrection(drift, &world.map);
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  applyAdjustment(*adjustment, &world.map);
  const double unit = world.map.keyframe(KeyframeId{0})->scale;
  EXPECT_NEAR(world.map.keyframe(KeyframeId{7})->scale, unit, 0.002);
  EXPECT_LT(worstCenterError(world), 1e-3);
}

TEST_F(GlobalAdjustmentTest, IsNotDisturbedByMismatches) {
  test::TrueMap world = walked(0.0);
  ASSERT_GE(swapPairs(&world, KeyframeId{4}), 5);
  world.disturb(0.005, 3);
  const auto adjustment = adjust(world);
  ASSERT_TRUE(adjustment.has_value());
  applyAdjustment(*adjustment, &world.map);
  EXPECT_LT(worstCenterError(world), 1e-4);
}

TEST_F(GlobalAdjustmentTest, GivesTheSameBitsTwice) {
  test::TrueMap world = walked(0.5);
  world.disturb(0.01, 4);
  const auto a = adjust(world), b = adjust(world);
  ASSERT_TRUE(a.has_value() && b.has_value());
  for (std::size_t i = 0; i < a->keyframes.size(); ++i) {
    EXPECT_EQ(a->keyframes[i].S_new_old.t, b->keyframes[i].S_new_old.t);
    EXPECT_EQ(a->keyframes[i].S_new_old.q.coeffs(), b->keyframes[i].S_new_old.q.coeffs());
  }
  for (std::size_t i = 0; i < a->landmarks.size(); ++i) {
    EXPECT_EQ(a->landmarks[i].shift, b->landmarks[i].shift);
  }
}

TEST_F(GlobalAdjustmentTest, HasNothingToSayWhenCancelledOrWithoutAMap) {
  const test::TrueMap world = walked(0.0);
  const std::atomic<bool> cancel{true};
  GlobalAdjustmentOptions options = options_;
  options.cancel = &cancel;
  EXPECT_FALSE(adjustGlobally(world.cloud.camera(), *world.snapshot(), options).has_value());
  EXPECT_FALSE(adjustGlobally(world.cloud.camera(), MapSnapshot{}, options_).has_value());
}

}  // namespace
}  // namespace glide
