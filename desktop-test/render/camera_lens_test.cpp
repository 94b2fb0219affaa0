// The lens that AR content is drawn through changes when the map has corrected it.
#include "render/camera_scene.h"

#include "gpu/gl_test.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr int kWidth = 160, kHeight = 120;

class CameraLens : public GlTest {
 protected:
  static CameraRenderer makeRenderer(const CameraIntrinsics& camera) {
    Result<CameraRenderer> made = CameraRenderer::create(GlStatePolicy::preserve, camera);
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
  /// Axes and a cube over a grey picture.
  static std::vector<std::uint8_t> arOver(CameraRenderer* renderer) {
    const std::vector<std::uint8_t> grey(std::size_t{kWidth} * kHeight, 90);
    const std::vector<Pose> cubes{{{0.22, 0.0, 0.1}}};
    ArContent content;
    content.cubes = cubes;
    const auto draw = [&](const Viewport& viewport) {
      EXPECT_TRUE(renderer->drawPicture(Luma{grey.data(), kWidth, kHeight, kWidth}, viewport).ok());
      EXPECT_TRUE(renderer->drawAr(content, lookAt({0.25, -0.4, -0.6}, {}), viewport).ok());
    };
    return drawn(kWidth, kHeight, draw).pixels;
  }
};

TEST_F(CameraLens, BendsARContentFromTheMomentItIsSet) {
  CameraRenderer corrected = makeRenderer(pinhole(kWidth, kHeight));
  CameraRenderer barrelled = makeRenderer(barrel(kWidth, kHeight));
  const std::vector<std::uint8_t> wanted = arOver(&barrelled);
  EXPECT_NE(arOver(&corrected), wanted);
  ASSERT_TRUE(corrected.setIntrinsics(barrel(kWidth, kHeight)).ok());
  EXPECT_EQ(arOver(&corrected), wanted);
}

TEST_F(CameraLens, StaysWhenWhatIsSetIsNone) {
  CameraRenderer renderer = makeRenderer(pinhole(kWidth, kHeight));
  const std::vector<std::uint8_t> before = arOver(&renderer);
  const Status refused = renderer.setIntrinsics({});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(arOver(&renderer), before);
}

}  // namespace
}  // namespace glide::test
