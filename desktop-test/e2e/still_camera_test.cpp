#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::test {
namespace {

constexpr int kStopFrame = 75;     // 2.5 s of motion make a map first
constexpr int kSettleFrames = 15;  // the stop itself may still deserve a keyframe
constexpr int kStillFrames = 150;  // 5 s
constexpr double kMaxDrift_m = 0.002;

TEST(StillCamera, NeitherDriftsNorAddsKeyframesInFiveSeconds) {
  constexpr int kBegin = kStopFrame + kSettleFrames;
  synthetic::SequenceOptions options = roomWalk(kBegin + kStillFrames);
  options.motion.pause_begin_s = kStopFrame / options.fps;
  options.motion.pause_end_s = options.motion.pause_begin_s + 60.0;  // beyond the end
  options.sensor.noise = 1.5;  // grey levels; without it every image would be the same
  const Playback run = play(options, inlineConfig());
  ASSERT_THAT(run, IsTrackedToTheEnd());
  EXPECT_EQ(run.keyframes.back(), run.keyframes[kBegin]) << describe(run);
  const double metres_per_unit = evaluate(run).metres_per_unit;
  double worst_m = 0.0;
  const auto& from = run.results[kBegin].T_world_cam.t_xyz;
  for (std::size_t i = kBegin; i < run.results.size(); ++i) {
    const auto& to = run.results[i].T_world_cam.t_xyz;
    const Vec3d drift(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    worst_m = std::max(worst_m, metres_per_unit * drift.norm());
  }
  EXPECT_LT(worst_m, kMaxDrift_m) << describe(run);
}

}  // namespace
}  // namespace glide::test
