#include "track/keyframe_policy.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

const Config::Keyframes kConfig;

TEST(KeyframePolicy, NeverAddsAKeyframeWhileTheCameraStandsStill) {
  for (int frames = 1; frames < 1000; frames += 7)
    EXPECT_FALSE(wantsKeyframe(kConfig, {frames, 300, 310, 0.0}));
}

TEST(KeyframePolicy, AddsOneWhenTheViewMovesOnAndLosesLandmarks) {
  EXPECT_TRUE(wantsKeyframe(kConfig, {kConfig.min_interval, 150, 300, 2.0 * kConfig.min_baseline}));
}

TEST(KeyframePolicy, WaitsForTheMinimumInterval) {
  EXPECT_FALSE(
      wantsKeyframe(kConfig, {kConfig.min_interval - 1, 150, 300, 2.0 * kConfig.min_baseline}));
}

TEST(KeyframePolicy, DoesNotWaitWhenAlmostNothingIsLeftToTrack) {
  EXPECT_TRUE(wantsKeyframe(kConfig, {1, kConfig.min_tracked - 1, 300, kConfig.min_baseline}));
}

TEST(KeyframePolicy, KeepsAnOldKeyframeThatStillServes) {
  EXPECT_FALSE(
      wantsKeyframe(kConfig, {kConfig.min_interval, 290, 300, 0.5 * kConfig.min_baseline}));
}

}  // namespace
}  // namespace glide
