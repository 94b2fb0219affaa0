#include "e2e/run_matchers.h"

#include "glide/enum_names.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

using ::testing::AnyOf;

constexpr double kTurn_s = 2.0;
constexpr int kTurnFrames = 60;
constexpr int kFrames = 160;

TEST(Start, PureRotationMakesNoMapAndTheTranslationAfterItMakesAGoodOne) {
  synthetic::SequenceOptions options = roomWalk(kFrames);
  options.motion.turn_first_s = kTurn_s;
  const Playback run = play(options, inlineConfig());
  for (std::size_t i = 0; i < kTurnFrames; ++i) {
    ASSERT_EQ(run.results[i].state, TrackingState::initializing) << "frame " << i;
    if (i == 0) continue;  // one image has no motion to judge
    EXPECT_THAT(run.results[i].initialization.status,
                AnyOf(InitializationStatus::pure_rotation, InitializationStatus::too_little_motion))
        << "frame " << i << ": " << enumName(run.results[i].initialization.status);
  }
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_THAT(run, IsAccurateAtDepth(typicalDepth_m(options.scene)));
}

}  // namespace
}  // namespace glide::test
