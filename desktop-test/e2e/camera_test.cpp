#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr int kFrames = 120;

void expectGoodRunWith(const CameraIntrinsics& camera) {
  synthetic::SequenceOptions options = roomWalk(kFrames);
  options.camera = camera;
  const Playback run = play(options, inlineConfig());
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_THAT(run, IsAccurateAtDepth(typicalDepth_m(options.scene)));
  EXPECT_THAT(run, IsMostlyDirect());
}

TEST(Cameras, PortraitImagesWorkLikeLandscapeOnes) {
  expectGoodRunWith(synthetic::makeCamera(DistortionModel::none, 240, 320));
}

TEST(Cameras, OddSizesWorkLikeEvenOnes) {
  expectGoodRunWith(synthetic::makeCamera(DistortionModel::none, 321, 239));
}

TEST(Cameras, ARadialTangentialLensWorksLikeAPinhole) {
  expectGoodRunWith(synthetic::makeCamera(DistortionModel::radial_tangential, 320, 240));
}

TEST(Cameras, AFisheyeWorksLikeAPinhole) {
  expectGoodRunWith(synthetic::makeCamera(DistortionModel::kannala_brandt4, 320, 240));
}

}  // namespace
}  // namespace glide::test
