#include "e2e/run_matchers.h"

#include "geometry/align_sim3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace glide::test {
namespace {

using synthetic::MotionKind;
using synthetic::SceneKind;

constexpr double kNoise = 2.0;  // grey levels

bool isTracked(const FrameResult& result) { return result.state == TrackingState::tracking; }

Vec3d positionOf(const Pose& pose) { return {pose.t_xyz[0], pose.t_xyz[1], pose.t_xyz[2]}; }

int trackedBetween(const Playback& run, int begin, int end) {
  return static_cast<int>(
      std::count_if(run.results.begin() + begin, run.results.begin() + end, isTracked));
}

/// Metres between the truth and a frame's pose as the app saw it, after the similarity that fits
/// the frames before `begin`.
double liveError(const Playback& run, int begin, int frame) {
  std::vector<Vec3d> truth;
  std::vector<Vec3d> estimate;
  for (std::size_t i = 0; i < static_cast<std::size_t>(begin); ++i) {
    if (!isTracked(run.results[i])) continue;
    truth.push_back(run.T_world_cam_truth[i].t);
    estimate.push_back(positionOf(run.results[i].T_world_cam));
  }
  const auto S = alignSim3(truth, estimate, AlignScale::estimated);
  if (!S) return std::numeric_limits<double>::infinity();
  const auto index = static_cast<std::size_t>(frame);
  const Vec3d estimate_now = positionOf(run.results[index].T_world_cam);
  return (run.T_world_cam_truth[index].t - *S * estimate_now).norm();
}

TEST(LastingMap, ACameraThatWasCarriedAwayIsFoundAgainWhereItIs) {
  synthetic::SequenceOptions options = roomWalk(200);
  options.motion.kind = MotionKind::orbit;
  options.sensor.noise = kNoise;
  options.kidnap = {150, 165, synthetic::KidnapView::black};
  const Playback run = play(options, inlineConfig());
  ASSERT_EQ(run.results.size(), 200U);
  EXPECT_EQ(trackedBetween(run, 150, 165), 0);
  constexpr int kWithin = 15;  // frames
  const auto back = std::find_if(run.results.begin() + 165, run.results.end(), isTracked);
  const int found = static_cast<int>(back - run.results.begin());
  ASSERT_LE(found, 165 + kWithin) << describe(run);
  EXPECT_EQ(trackedBetween(run, found, 200), 200 - found) << describe(run);
  constexpr double kMaxError = 0.05;  // metres
  for (int frame = found; frame < 200; ++frame)
    EXPECT_LT(liveError(run, 150, frame), kMaxError) << "frame " << frame;
  EXPECT_EQ(run.map->resets, 0U);
}

TEST(LastingMap, GoingOnceAroundClosesALoopThatHalvesTheError) {
  synthetic::SequenceOptions options = roomWalk(345);
  options.motion.kind = MotionKind::orbit;
  options.motion.speed = 2.0;  // a round takes 300 frames
  options.sensor.noise = kNoise;
  const Playback closed = play(options, inlineConfig());
  Config config = inlineConfig();
  config.loop.closing = LoopClosing::off;
  const Playback open = play(options, config);
  EXPECT_THAT(closed, IsTrackedToTheEnd());
  EXPECT_GE(closed.map->loops.size(), 1U);
  EXPECT_EQ(open.map->loops.size(), 0U);
  EXPECT_LT(evaluate(closed).ate_rmse_m, 0.5 * evaluate(open).ate_rmse_m);
}

TEST(LastingMap, BaysThatAreAlikeAreNotTakenForOnePlace) {
  synthetic::SequenceOptions options = roomWalk(240);
  options.scene = SceneKind::arcade;
  options.motion.kind = MotionKind::walk;
  options.sensor.noise = kNoise;
  const Playback run = play(options, inlineConfig());
  EXPECT_LT(firstPose(run), 30);
  EXPECT_EQ(run.map->loops.size(), 0U);
}

}  // namespace
}  // namespace glide::test
