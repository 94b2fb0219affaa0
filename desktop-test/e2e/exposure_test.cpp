#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr int kFrames = 120;

TEST(Exposure, AGainThatGrowsFourfoldKeepsTheDirectShareWithinTenPoints) {
  synthetic::SequenceOptions options = roomWalk(kFrames);
  const Playback steady = play(options, inlineConfig());
  options.sensor.gain_begin = 0.5;
  options.sensor.gain_end = 2.0;
  const Playback ramp = play(options, inlineConfig());
  EXPECT_THAT(ramp, IsTrackedToTheEnd());
  EXPECT_NEAR(directShare(ramp), directShare(steady), 0.10)
      << "ramp: " << describe(ramp) << "\nsteady: " << describe(steady);
}

}  // namespace
}  // namespace glide::test
