#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

using synthetic::SceneKind;

constexpr int kFrames = 150;

void expectGoodRunIn(SceneKind kind) {
  synthetic::SequenceOptions options = roomWalk(kFrames);
  options.scene = kind;
  const Playback run = play(options, inlineConfig());
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_THAT(run, IsAccurateAtDepth(typicalDepth_m(kind)));
  EXPECT_THAT(run, IsMostlyDirect());
}

TEST(Scenes, ARoomIsTrackedToTwoMillimetresMostlyByTheDirectTracker) {
  expectGoodRunIn(SceneKind::room);
}

TEST(Scenes, AFacadeIsTrackedInProportionToItsDepth) { expectGoodRunIn(SceneKind::facade); }

TEST(Scenes, APlanarDeskIsTrackedInProportionToItsDepth) { expectGoodRunIn(SceneKind::desk); }

TEST(Scenes, ALivingRoomInColourIsTrackedFromAroundItsTable) {
  constexpr int kArcFrames = 75;      // a fifth of a round: nothing is seen again
  constexpr double kMaxAte_m = 0.01;  // half the resolution of the demo, on 1.5 m
  synthetic::SequenceOptions options = roomWalk(kArcFrames);
  options.scene = SceneKind::living_room;
  options.motion.kind = synthetic::MotionKind::orbit;
  options.motion.speed = 1.6;
  options.sensor.metering = 0.5;
  const Playback run = play(options, inlineConfig());
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_LT(evaluate(run).ate_rmse_m, kMaxAte_m) << describe(run);
  EXPECT_THAT(run, IsMostlyDirect());
}

TEST(Scenes, AFacadeWhoseBaysAreAlikeIsNotTakenForItselfOneBayFurther) {
  constexpr int kWalkFrames = 200;    // 13 m, nearly five bays
  constexpr double kMaxAte_m = 0.05;  // a brick is 0.3 m, a bay 2.7 m
  synthetic::SequenceOptions options = roomWalk(kWalkFrames);
  options.scene = SceneKind::arcade;
  options.motion.kind = synthetic::MotionKind::walk;
  options.sensor.noise = 2.0;
  const Playback run = play(options, inlineConfig());
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_LT(evaluate(run).ate_rmse_m, kMaxAte_m) << describe(run);
}

}  // namespace
}  // namespace glide::test
