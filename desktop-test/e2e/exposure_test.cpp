#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr int kFrames = 120;
constexpr double kMaxShareChange = 0.10;

void expectTrackedLikeSteadyExposure(const synthetic::Sensor& sensor) {
  synthetic::SequenceOptions options = roomWalk(kFrames);
  const Playback steady = play(options, inlineConfig());
  options.sensor = sensor;
  const Playback changing = play(options, inlineConfig());
  EXPECT_THAT(changing, IsTrackedToTheEnd());
  EXPECT_NEAR(directShare(changing), directShare(steady), kMaxShareChange)
      << "changing: " << describe(changing) << "\nsteady: " << describe(steady);
}

TEST(Exposure, AGainThatGrowsFourfoldKeepsTheDirectShareWithinTenPoints) {
  synthetic::Sensor sensor;
  sensor.gain_begin = 0.5;
  sensor.gain_end = 2.0;
  expectTrackedLikeSteadyExposure(sensor);
}

// The ramp is slow enough for brightness constancy; this one is not: without the gain of each frame
// the direct share falls to 0.37.
TEST(Exposure, AGainThatJumpsByAThirdEachFrameKeepsTheDirectShareWithinTenPoints) {
  synthetic::Sensor sensor;
  sensor.flicker = 0.3;
  expectTrackedLikeSteadyExposure(sensor);
}

}  // namespace
}  // namespace glide::test
