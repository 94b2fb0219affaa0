#include "gpu/texture_placement.h"

#include "support/app_texture.h"

#include "gpu/gl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace glide::test {
namespace {

using ::testing::FloatNear;
using ::testing::HasSubstr;

constexpr FrameSize kFrame{640, 480};

Texture textureOf(int width, int height, const TextureTransform& transform) {
  return {1, GL_TEXTURE_2D, width, height, transform};
}

/// Texel that pixel (x, y) is sampled at; its centre is at half numbers.
std::array<float, 2> texelAt(const Texture& texture, float x, float y) {
  const TexturePlacement place = placeTexture(texture, kFrame);
  return {(place.origin[0] + x * place.per_column[0] + y * place.per_row[0]) *
              static_cast<float>(texture.width),
          (place.origin[1] + x * place.per_column[1] + y * place.per_row[1]) *
              static_cast<float>(texture.height)};
}

void expectTexel(const std::array<float, 2>& texel, float u, float v) {
  constexpr float kTolerance = 1e-3F;
  EXPECT_THAT(texel[0], FloatNear(u, kTolerance));
  EXPECT_THAT(texel[1], FloatNear(v, kTolerance));
}

std::string refusal(const Texture& texture) {
  const Status status = checkPlacement(texture, kFrame);
  if (status) return "";
  EXPECT_EQ(status.error().code, ErrorCode::invalid_argument);
  return status.error().message;
}

TEST(TexturePlacement, PutsTheFirstRowOfMemoryOnTopUnlessToldOtherwise) {
  const Texture upper = textureOf(640, 480, Texture().transform);
  expectTexel(texelAt(upper, 0, 0), 0.5F, 0.5F);
  expectTexel(texelAt(upper, 639, 479), 639.5F, 479.5F);
  const Texture lower = textureOf(640, 480, kLowerRowFirst);
  expectTexel(texelAt(lower, 0, 0), 0.5F, 479.5F);
  expectTexel(texelAt(lower, 639, 0), 639.5F, 479.5F);
}

TEST(TexturePlacement, TurnsWithTheTransform) {
  // A phone's camera is mounted sideways: SurfaceTexture turns its 480x640 buffer by a quarter.
  const Texture turned = textureOf(480, 640, affineTransform({0, 1, 0}, {1, 0, 0}));
  EXPECT_EQ(refusal(turned), "");
  expectTexel(texelAt(turned, 0, 0), 479.5F, 0.5F);
  expectTexel(texelAt(turned, 639, 0), 479.5F, 639.5F);
  expectTexel(texelAt(turned, 0, 479), 0.5F, 0.5F);
}

TEST(TexturePlacement, KnowsWhenPixelsAreTexels) {
  EXPECT_TRUE(placeTexture(textureOf(640, 480, kUpperRowFirst), kFrame).hits_texels);
  EXPECT_TRUE(
      placeTexture(textureOf(480, 640, affineTransform({0, 1, 0}, {1, 0, 0})), kFrame).hits_texels);
  // A crop by whole texels out of twice the size, and one by half texels.
  EXPECT_TRUE(
      placeTexture(textureOf(1280, 960, affineTransform({0.5F, 0, 0.25F}, {0, -0.5F, 0.75F})),
                   kFrame)
          .hits_texels);
  EXPECT_FALSE(
      placeTexture(textureOf(1280, 960, affineTransform({0.5F, 0, 0.5F / 1280}, {0, -0.5F, 0.75F})),
                   kFrame)
          .hits_texels);
  EXPECT_FALSE(placeTexture(textureOf(1280, 960, kUpperRowFirst), kFrame).hits_texels);
}

TEST(TexturePlacement, AcceptsAnyScaleThatKeepsTheAspect) {
  EXPECT_EQ(refusal(textureOf(1280, 960, kUpperRowFirst)), "");
  EXPECT_EQ(refusal(textureOf(320, 240, kUpperRowFirst)), "");
  // SurfaceTexture shrinks the crop of a buffer by a texel on each side.
  EXPECT_EQ(refusal(textureOf(
                640,
                480,
                affineTransform({638.0F / 640, 0, 1.0F / 640}, {0, -478.0F / 480, 479.0F / 480}))),
            "");
}

TEST(TexturePlacement, RefusesWhatIsNoTextureAndNamesIt) {
  Texture texture = textureOf(640, 480, kUpperRowFirst);
  texture.name = 0;
  EXPECT_THAT(refusal(texture), HasSubstr("the image's name"));
  texture = textureOf(640, 480, kUpperRowFirst);
  texture.target = GL_TEXTURE_3D;
  EXPECT_THAT(refusal(texture), HasSubstr("the image's target"));
  EXPECT_THAT(refusal(textureOf(640, 0, kUpperRowFirst)), HasSubstr("height"));
}

TEST(TexturePlacement, RefusesTransformsThatDistort) {
  EXPECT_THAT(refusal(textureOf(480, 640, kUpperRowFirst)), HasSubstr("480x640"));
  EXPECT_THAT(refusal(textureOf(640, 480, affineTransform({0, 0, 0}, {0, 0, 0}))),
              HasSubstr("stretched"));
  EXPECT_THAT(refusal(textureOf(640, 480, affineTransform({1, 0.2F, 0}, {0, 1, 0}))),
              HasSubstr("stretched"));
  EXPECT_THAT(refusal(textureOf(640, 480, affineTransform({1, 0, 0.1F}, {0, 1, 0}))),
              HasSubstr("leaves"));
  TextureTransform perspective = kUpperRowFirst;
  perspective[3] = 0.1F;
  EXPECT_THAT(refusal(textureOf(640, 480, perspective)), HasSubstr("affine"));
  TextureTransform broken = kUpperRowFirst;
  broken[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(textureOf(640, 480, broken)), HasSubstr("affine"));
}

}  // namespace
}  // namespace glide::test
