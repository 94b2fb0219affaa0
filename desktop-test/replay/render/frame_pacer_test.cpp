#include "replay/render/frame_pacer.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glide::replay {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(FrameRate, IsThatOfTheMedianInterval) {
  EXPECT_NEAR(frameRate(std::array{0 * kMs, 50 * kMs, 100 * kMs, 900 * kMs, 950 * kMs}), 20, 1e-9);
}

TEST(FrameRate, StaysWithinWhatVideosHave) {
  EXPECT_EQ(frameRate(std::array<std::int64_t, 2>{0, 1}), 240.0);
  EXPECT_EQ(frameRate(std::array<std::int64_t, 2>{0, 60'000 * kMs}), 1.0);
}

TEST(FramePacer, GivesEveryFrameAStepWhenTheRateIsRight) {
  FramePacer pacer(30.0, 0);
  for (std::int64_t i = 0; i < 300; ++i) {
    const std::int64_t jitter = (i % 3 - 1) * 15 * kMs;
    EXPECT_EQ(pacer.steps(i * 33'333'333 + jitter), 1) << i;
  }
}

TEST(FramePacer, CorrectsARateThatIsOff) {
  for (const double rate : {27.0, 33.0}) {
    FramePacer pacer(rate, 0);
    int steps = 0;
    for (std::int64_t i = 0; i < 300; ++i) steps += pacer.steps(i * 33'333'333);
    EXPECT_NEAR(steps, 10.0 * rate, 2.0);
  }
}

TEST(FramePacer, HoldsTheFrameBeforeAGap) {
  FramePacer pacer(20.0, 1000 * kMs);
  EXPECT_EQ(pacer.steps(1000 * kMs), 1);
  EXPECT_EQ(pacer.steps(2000 * kMs), 20);
  EXPECT_EQ(pacer.steps(2050 * kMs), 1);
}

TEST(FramePacer, CutsAnEndlessGapShort) {
  FramePacer pacer(20.0, 0);
  EXPECT_EQ(pacer.steps(0), 1);
  EXPECT_EQ(pacer.steps(3'600'000 * kMs), 201);
  EXPECT_EQ(pacer.steps(3'600'050 * kMs), 1);
}

}  // namespace
}  // namespace glide::replay
