#include "replay/outputs/statistics.h"

#include "replay/outputs/run_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

FrameCounts countsOf(const RunFixture& fixture) {
  return countFrames(fixture.run, buildTrajectories(fixture.run));
}

TEST(Spread, InterpolatesBetweenRanks) {
  const auto spread = spreadOf({4.0, 1.0, 3.0, 2.0});
  ASSERT_TRUE(spread.has_value());
  EXPECT_DOUBLE_EQ(spread->median, 2.5);
  EXPECT_DOUBLE_EQ(spread->p95, 3.85);
  EXPECT_DOUBLE_EQ(spread->max, 4.0);
  EXPECT_DOUBLE_EQ(spread->mean, 2.5);
  EXPECT_FALSE(spreadOf({}).has_value());
  EXPECT_DOUBLE_EQ(spreadOf({7.0})->p95, 7.0);
}

TEST(Trajectories, AreRecomposedFromTheFinalKeyframesRetiredOnesToo) {
  RunFixture fixture;
  fixture.addKeyframe(1, 10.0, false);
  fixture.addKeyframe(2, 20.0, true);
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addTracked(TrackerKind::direct, 2);
  fixture.run.frames[1].result.T_ref_cam.t_xyz = {0, 1, 0};
  fixture.run.frames[1].result.T_world_cam.t_xyz = {19, 1, 0};
  const RunTrajectories trajectories = buildTrajectories(fixture.run);
  ASSERT_EQ(trajectories.camera.recomposed.size(), 2u);
  EXPECT_LT((trajectories.camera.recomposed[1].T_world_rig.t - Vec3d(20, 1, 0)).norm(), 1e-12);
  EXPECT_LT((trajectories.camera.live[1].T_world_rig.t - Vec3d(19, 1, 0)).norm(), 1e-12);
  ASSERT_EQ(trajectories.camera.keyframes.size(), 1u);
  EXPECT_EQ(trajectories.camera.keyframes[0].t_ns, 1);
}

TEST(Trajectories, StretchWithTheScaleThatTheirKeyframeHasGained) {
  RunFixture fixture;
  fixture.addKeyframe(1, 10.0, false);
  fixture.map().keyframes[0].scale = 3.0;
  fixture.addTracked(TrackerKind::direct, 1);
  fixture.run.frames[0].result.T_ref_cam.t_xyz = {0, 1, 0};
  fixture.run.frames[0].result.reference_scale = 1.5;
  const RunTrajectories trajectories = buildTrajectories(fixture.run);
  EXPECT_LT((trajectories.camera.recomposed[0].T_world_rig.t - Vec3d(10, 2, 0)).norm(), 1e-12);
}

TEST(Spread, AddsThePyramidWhereTheStageRan) {
  RunFixture fixture;
  fixture.addTracked(TrackerKind::direct, 1);
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.run.frames[0].result.stats.pyramid_ms = 2.0;
  fixture.run.frames[0].result.stats.align_ms = 3.0;
  fixture.run.frames[1].result.stats.pyramid_ms = 9.0;
  const auto spread = spreadWithPyramid(fixture.run, &FrameStats::align_ms);
  ASSERT_TRUE(spread.has_value());
  EXPECT_DOUBLE_EQ(spread->max, 5.0);
}

TEST(Trajectories, KeepOnlyTheLastMap) {
  RunFixture fixture;
  fixture.addKeyframe(1, 0.0, true);  // of the map that was given up
  fixture.addKeyframe(7, 5.0, false);
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addLost();
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 7);
  fixture.addTracked(TrackerKind::direct, 7);
  const RunTrajectories trajectories = buildTrajectories(fixture.run);
  EXPECT_EQ(trajectories.camera.recomposed.size(), 2u);
  EXPECT_EQ(trajectories.of_older_maps, 1);
  const FrameCounts counts = countsOf(fixture);
  EXPECT_EQ(counts.in, 6);
  EXPECT_EQ(counts.tracked, 2);
  EXPECT_EQ(counts.lost, 2);
  EXPECT_EQ(counts.initializing, 2);
  EXPECT_EQ(counts.first_pose_index, 1);
  EXPECT_DOUBLE_EQ(counts.tracked_ratio, 2.0 / 5.0);
}

TEST(Trajectories, KeepTheLastMapThoughTheRunEndsWithoutOne) {
  RunFixture fixture;
  fixture.addKeyframe(1, 0.0, false);
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addLost();
  fixture.addInitializing();
  EXPECT_EQ(buildTrajectories(fixture.run).camera.recomposed.size(), 1u);
}

TEST(FrameCounts, AddUpAndShareOutTheTracked) {
  RunFixture fixture;
  fixture.addKeyframe(1, 0.0, false);
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addTracked(TrackerKind::direct, 1);
  fixture.addTracked(TrackerKind::direct, 1);
  fixture.addLost();
  fixture.addTracked(TrackerKind::indirect, 1);
  const FrameCounts counts = countsOf(fixture);
  EXPECT_EQ(counts.tracked, 4);
  EXPECT_EQ(counts.direct, 2);
  EXPECT_EQ(counts.indirect, 2);
  EXPECT_EQ(counts.lost, 1);
  EXPECT_EQ(counts.relocalisations, 1);
  EXPECT_DOUBLE_EQ(counts.tracked_ratio, 0.8);
  EXPECT_DOUBLE_EQ(counts.direct_share, 0.5);
}

TEST(FrameCounts, HaveNoFirstPoseWhenNothingWasTracked) {
  RunFixture fixture;
  fixture.addInitializing();
  const FrameCounts counts = countsOf(fixture);
  EXPECT_FALSE(counts.first_pose_index.has_value());
  EXPECT_EQ(counts.tracked_ratio, 0.0);
}

TEST(StageSpread, CountsOnlyFramesInWhichTheStageRan) {
  RunFixture fixture;
  fixture.addInitializing();
  fixture.addInitializing();
  fixture.run.frames[1].result.stats.align_ms = 3.0;
  EXPECT_DOUBLE_EQ(stageSpread(fixture.run, &FrameStats::align_ms)->mean, 3.0);
  EXPECT_FALSE(stageSpread(fixture.run, &FrameStats::match_ms).has_value());
}

TEST(UpdateSpread, SeparatesTheTrackers) {
  RunFixture fixture;
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addTracked(TrackerKind::direct, 1);
  EXPECT_DOUBLE_EQ(updateSpread(fixture.run, TrackerKind::direct)->median, 2.0);
  EXPECT_DOUBLE_EQ(updateSpread(fixture.run, std::nullopt)->median, 1.5);
}

}  // namespace
}  // namespace glide::replay
