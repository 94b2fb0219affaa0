#include "replay/render/truth_overlay.h"

#include "replay/evaluation/random_trajectories.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace glide::replay {
namespace {

constexpr std::int64_t kPeriodNs = 50'000'000;

Pose poseOf(const SE3d& T) {
  return {{T.t.x(), T.t.y(), T.t.z()}, {T.q.x(), T.q.y(), T.q.z(), T.q.w()}};
}

/// A frame that was tracked relative to the only keyframe, which is the map's origin.
FrameRecord frameAt(int index, const StampedPose& pose) {
  FrameRecord frame;
  frame.index = index;
  frame.result.t_ns = pose.t_ns;
  frame.result.state = TrackingState::tracking;
  frame.result.T_world_cam = frame.result.T_ref_cam = poseOf(pose.T_world_rig);
  return frame;
}

std::shared_ptr<const MapView> mapOfOneKeyframe() {
  auto map = std::make_shared<MapView>();
  map->keyframes.emplace_back();
  return map;
}

TEST(TruthOverlay, LiesOnThePathInTheMapsUnit) {
  const Trajectory truth = smoothPath(0, kPeriodNs, 200);
  const Trajectory estimate = estimateOf(truth, 0.0, 3);
  TruthOverlay overlay(truth);
  for (std::size_t i = 40; i < 100; ++i) {
    overlay.add(frameAt(static_cast<int>(i), estimate[i]));
  }
  const std::vector<Pose> aligned = overlay.alignedTo(mapOfOneKeyframe());
  ASSERT_EQ(aligned.size(), 60U);  // what has been driven, not what is to come
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    const Vec3d p(aligned[i].t_xyz[0], aligned[i].t_xyz[1], aligned[i].t_xyz[2]);
    EXPECT_NEAR((p - estimate[i + 40].T_world_rig.t).norm(), 0.0, 1e-9);
  }
}

TEST(TruthOverlay, WaitsUntilThereIsEnoughToAlign) {
  const Trajectory truth = smoothPath(0, kPeriodNs, 200);
  const Trajectory estimate = estimateOf(truth, 0.0, 3);
  TruthOverlay overlay(truth);
  EXPECT_TRUE(overlay.alignedTo(mapOfOneKeyframe()).empty());
  for (std::size_t i = 0; i < 10; ++i) overlay.add(frameAt(static_cast<int>(i), estimate[i]));
  EXPECT_TRUE(overlay.alignedTo(mapOfOneKeyframe()).empty());
}

TEST(TruthOverlay, IsEmptyWithoutATruth) {
  TruthOverlay overlay({});
  overlay.add({});
  EXPECT_TRUE(overlay.alignedTo(mapOfOneKeyframe()).empty());
}

TEST(TruthOverlay, ThinsOutATruthOfManyPoses) {
  const Trajectory dense = smoothPath(0, kPeriodNs / 50, 10'000);
  Trajectory sparse;
  for (std::size_t i = 0; i < dense.size(); i += 50) sparse.push_back(dense[i]);
  const Trajectory estimate = estimateOf(sparse, 0.0, 3);
  TruthOverlay overlay(dense);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    overlay.add(frameAt(static_cast<int>(i), estimate[i]));
  }
  const std::size_t poses = overlay.alignedTo(mapOfOneKeyframe()).size();
  EXPECT_GT(poses, 1'000U);
  EXPECT_LE(poses, 2'000U);
}

}  // namespace
}  // namespace glide::replay
