#include "session/pose_timeline.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace glide {
namespace {

constexpr std::int64_t kFrame_ns = 33'000'000;
constexpr std::uint64_t kGeneration = 3;

/// Camera `n` frames on its way: it moves along x and turns about y at constant speed.
AnchoredPose poseAfter(double n) {
  AnchoredPose pose;
  pose.T_key_world = SE3d::exp((Vec6d() << -0.1, 0.0, 0.0, 0.0, 0.02, 0.0).finished() * n);
  return pose;
}

PoseTimeline timelineOf(int frames) {
  PoseTimeline timeline(kGeneration);
  for (int i = 0; i < frames; ++i) timeline = timeline.with({i * kFrame_ns, true, poseAfter(i)});
  return timeline;
}

void expectPose(const LocatedCamera& located, double n) {
  const Vec3d expected = poseAfter(n).T_key_world.inverse().t;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(located.T_world_cam.t_xyz[static_cast<std::size_t>(axis)], expected[axis], 1e-9);
}

TEST(PoseTimeline, KnowsNothingWhenItIsEmpty) {
  const LocatedCamera located = PoseTimeline(kGeneration).at(5, MapSnapshot());
  EXPECT_FALSE(located.valid);
  EXPECT_FALSE(located.tracked);
  EXPECT_EQ(located.t_ns, 5);
  EXPECT_EQ(located.map_generation, kGeneration);
}

TEST(PoseTimeline, InterpolatesBetweenFrames) {
  const LocatedCamera located = timelineOf(10).at(4 * kFrame_ns + kFrame_ns / 2, MapSnapshot());
  EXPECT_TRUE(located.valid);
  EXPECT_TRUE(located.tracked);
  expectPose(located, 4.5);
}

TEST(PoseTimeline, AnswersAtAFrameWithItsPose) {
  for (const int frame : {0, 3, 9}) {
    const LocatedCamera located = timelineOf(10).at(frame * kFrame_ns, MapSnapshot());
    EXPECT_TRUE(located.tracked);
    expectPose(located, frame);
  }
}

TEST(PoseTimeline, PredictsALittleAndSaysThatItIsAPrediction) {
  const LocatedCamera located = timelineOf(10).at(11 * kFrame_ns, MapSnapshot());
  EXPECT_TRUE(located.valid);
  EXPECT_FALSE(located.tracked);
  expectPose(located, 11.0);
}

TEST(PoseTimeline, DoesNotPredictFarAndHoldsTheLastPose) {
  const std::int64_t late = 9 * kFrame_ns + PoseTimeline::kMaxExtrapolation_ns + 1;
  const LocatedCamera located = timelineOf(10).at(late, MapSnapshot());
  EXPECT_FALSE(located.valid);
  expectPose(located, 9.0);
}

TEST(PoseTimeline, IsNotValidBeforeItsFirstFrame) {
  EXPECT_FALSE(timelineOf(10).at(-1, MapSnapshot()).valid);
}

TEST(PoseTimeline, IsNotValidWhileLost) {
  PoseTimeline timeline = timelineOf(5);
  timeline = timeline.with({5 * kFrame_ns, false, poseAfter(4)});
  EXPECT_FALSE(timeline.at(5 * kFrame_ns, MapSnapshot()).valid);
  EXPECT_FALSE(timeline.at(4 * kFrame_ns + 1, MapSnapshot()).valid);
  EXPECT_FALSE(timeline.at(5 * kFrame_ns + 1, MapSnapshot()).valid);
  EXPECT_TRUE(timeline.at(4 * kFrame_ns, MapSnapshot()).valid);
}

TEST(PoseTimeline, DoesNotInterpolateAcrossALongGap) {
  PoseTimeline timeline = timelineOf(5);
  timeline = timeline.with({4 * kFrame_ns + 1'000'000'000, true, poseAfter(5)});
  EXPECT_FALSE(timeline.at(4 * kFrame_ns + 500'000'000, MapSnapshot()).valid);
}

TEST(PoseTimeline, ForgetsWhatIsOld) {
  const PoseTimeline timeline = timelineOf(500);
  EXPECT_FALSE(timeline.at(kFrame_ns, MapSnapshot()).valid);
  EXPECT_TRUE(timeline.at(498 * kFrame_ns + 1, MapSnapshot()).valid);
}

}  // namespace
}  // namespace glide
