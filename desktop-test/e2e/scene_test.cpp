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

}  // namespace
}  // namespace glide::test
