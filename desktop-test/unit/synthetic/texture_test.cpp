#include "synthetic/texture.h"

#include <gtest/gtest.h>

namespace glide::synthetic {
namespace {

/// Stripes of one texel, 0 and 200, 64 x 32.
Texture stripes() {
  ImageF image(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) image.at(x, y) = x % 2 == 0 ? 0.0F : 200.0F;
  }
  return Texture(image);
}

TEST(Texture, IsExactAtTheCentresOfTexels) {
  EXPECT_FLOAT_EQ(stripes().sample<float>(4.5F, 3.5F, 1.0F), 0.0F);
  EXPECT_FLOAT_EQ(stripes().sample<float>(5.5F, 3.5F, 1.0F), 200.0F);
  EXPECT_NEAR(stripes().sample<float>(5.25F, 3.5F, 1.0F), 150.0F, 0.1F);
}

TEST(Texture, AveragesOverTheFootprint) {
  for (const float u : {10.3F, 11.0F, 14.7F})
    EXPECT_NEAR(stripes().sample<float>(u, 10.0F, 4.0F), 100.0F, 1.0F) << u;
}

TEST(Texture, RepeatsItsBorder) {
  EXPECT_FLOAT_EQ(stripes().sample<float>(-50.0F, -50.0F, 1.0F), 0.0F);
  EXPECT_FLOAT_EQ(stripes().sample<float>(0.5F, 500.0F, 1.0F), 0.0F);
}

TEST(Texture, KeepsColoursApart) {
  ImageRgb image(2, 2);
  for (int y = 0; y < 2; ++y) {
    image.at(0, y) = {10.0F, 20.0F, 30.0F};
    image.at(1, y) = {20.0F, 40.0F, 250.0F};
  }
  const Texture texture(image);
  EXPECT_TRUE(texture.sample<Vec3f>(0.5F, 1.0F, 1.0F).isApprox(Vec3f(10, 20, 30)));
  EXPECT_TRUE(texture.sample<Vec3f>(1.0F, 1.0F, 1.0F).isApprox(Vec3f(15, 30, 140.0F)));
  EXPECT_TRUE(texture.sample<Vec3f>(1.0F, 1.0F, 8.0F).isApprox(Vec3f(15, 30, 140.0F)));
}

TEST(Texture, EndsInOneTexel) {
  EXPECT_NEAR(stripes().sample<float>(9.0F, 9.0F, 1e6F), 100.0F, 0.1F);
}

}  // namespace
}  // namespace glide::synthetic
