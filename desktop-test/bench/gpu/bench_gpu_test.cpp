// What the benchmark computes itself: byte counts, medians and the verdict on growth.
#include "bench/gpu/sweep.h"
#include "bench/gpu/traffic.h"

#include <gtest/gtest.h>

namespace glide::gpubench {
namespace {

constexpr auto kPyramid = static_cast<std::size_t>(GpuStage::pyramid);
constexpr auto kTrack = static_cast<std::size_t>(GpuStage::track);

Workload smallWorkload() {
  Workload workload;
  workload.width = 33;
  workload.height = 16;
  workload.points = 10;
  workload.patch = 5;
  workload.levels = 2;
  return workload;
}

TEST(Traffic, OfAFusedPyramidIsTheLevelsThemselves) {
  const auto stages = countTraffic(smallWorkload(), {GpuPlan::fused, {}, {}});
  EXPECT_DOUBLE_EQ(stages[kPyramid].read, 4.0 * 33 * 16);
  EXPECT_DOUBLE_EQ(stages[kPyramid].written, 4.0 * 17 * 8);
}

TEST(Traffic, OfTwoPassesHasTheBlurredRowsBesides) {
  const auto fused = countTraffic(smallWorkload(), {GpuPlan::fused, {}, {}});
  const auto paper = countTraffic(smallWorkload(), {GpuPlan::paper, {}, {}});
  EXPECT_DOUBLE_EQ(paper[kPyramid].written - fused[kPyramid].written, 4.0 * 33 * 16);
  EXPECT_DOUBLE_EQ(paper[kPyramid].read - fused[kPyramid].read, 4.0 * 17 * 16);
}

TEST(Traffic, OfTrackIsThatOfEachPointInEachIteration) {
  TrafficCase what{GpuPlan::fused, {}, {}};
  what.points[0] = 10.0;
  what.points[1] = 4.0;
  what.iterations[0] = 2.0;
  what.iterations[1] = 3.0;
  const auto stages = countTraffic(smallWorkload(), what);
  constexpr double kState = 208.0, kIterations = 5.0, kPoints = 2 * 10.0 + 3 * 4.0;
  EXPECT_DOUBLE_EQ(stages[kTrack].read,
                   kPoints * (16 + 16 + 12 * 25 + 4 * 36 + 32 + 112) + kIterations * 2 * kState);
  EXPECT_DOUBLE_EQ(stages[kTrack].written, kPoints * (32 + 8) + kIterations * kState);
  what.plan = GpuPlan::paper;
  EXPECT_DOUBLE_EQ(countTraffic(smallWorkload(), what)[kTrack].read,
                   kPoints * (16 + 28 * 25 + 4 * 36 + 32) + kIterations * (48 + 96 + 3 * kState));
}

TEST(Spread, InterpolatesBetweenTheValuesAroundARank) {
  const Spread spread = spreadOf({3.0, 1.0, 2.0, 4.0});
  EXPECT_DOUBLE_EQ(spread.median, 2.5);
  EXPECT_NEAR(spread.p95, 3.85, 1e-12);
}

Sweep sweepOf(const std::vector<double>& frame_ms) {
  Sweep sweep;
  sweep.plans = {GpuPlan::fused};
  int points = 250;
  for (const double ms : frame_ms) {
    sweep.points.push_back({points, 11, {ms}});
    points *= 2;
  }
  sweep.patches = {{1000, 5, {1.0}}, {1000, 7, {1.0}}};
  return sweep;
}

TEST(Sweep, IsLinearWhenTheCostDoublesWithTheWork) {
  EXPECT_TRUE(sweepOf({1.0, 2.0, 4.0}).isLinear());
  EXPECT_TRUE(sweepOf({1.0, 1.2, 1.9}).isLinear());
}

TEST(Sweep, IsNotLinearWhenTheCostGrowsFasterAnywhere) {
  EXPECT_FALSE(sweepOf({1.0, 1.0, 2.5}).isLinear());
  EXPECT_FALSE(sweepOf({1.0, 2.2, 4.8}).isLinear());
}

}  // namespace
}  // namespace glide::gpubench
