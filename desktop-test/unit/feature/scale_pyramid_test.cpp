#include "feature/scale_pyramid.h"

#include "unit/feature/dead_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace glide {
namespace {

constexpr ScalePyramid::Shape kShape{8, 1.2, 33};

TEST(ScalePyramid, ShrinksByItsFactorFromLevelToLevel) {
  const ImageU8 image = test::DeadLeaves(8).render(320, 241);
  ScalePyramid pyramid(kShape);
  pyramid.build(image.view());
  ASSERT_EQ(pyramid.levels(), 8);
  for (int l = 0; l < 8; ++l) {
    EXPECT_NEAR(pyramid.level(l).width, 320 / std::pow(1.2, l), 0.51);
    EXPECT_NEAR(pyramid.level(l).height, 241 / std::pow(1.2, l), 0.51);
  }
}

TEST(ScalePyramid, LeavesOutLevelsThatAreTooSmall) {
  const ImageU8 image = test::DeadLeaves(8).render(40, 200);
  ScalePyramid pyramid(kShape);
  pyramid.build(image.view());
  EXPECT_EQ(pyramid.levels(), 2);  // 40 and 33 px wide; 28 px would be next
}

TEST(ScalePyramid, MapsTheOuterEdgesOfEachLevelOntoThoseOfTheImage) {
  const ImageU8 image = test::DeadLeaves(8).render(321, 243);
  ScalePyramid pyramid(kShape);
  pyramid.build(image.view());
  for (int l = 0; l < pyramid.levels(); ++l) {
    const ImageViewU8& level = pyramid.level(l);
    const Vec2f corner(static_cast<float>(level.width) - 0.5F,
                       static_cast<float>(level.height) - 0.5F);
    EXPECT_LT((pyramid.toLevel0(l, Vec2f(-0.5F, -0.5F)) - Vec2f(-0.5F, -0.5F)).norm(), 1e-4F);
    EXPECT_LT((pyramid.toLevel0(l, corner) - Vec2f(320.5F, 242.5F)).norm(), 1e-3F);
  }
}

/// Centre of mass of what is brighter than the background.
Vec2f centroid(const ImageViewU8& image, int background) {
  Vec2f sum = Vec2f::Zero();
  float mass = 0.0F;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const float m = static_cast<float>(image.at(x, y) - background);
      sum += m * Vec2f(static_cast<float>(x), static_cast<float>(y));
      mass += m;
    }
  }
  return sum / mass;
}

TEST(ScalePyramid, KeepsASpotInItsPlaceOnEveryLevelToATenthOfAPixel) {
  constexpr float kSigma = 9.0F;
  for (const Vec2f& spot : {Vec2f(80.0F, 60.0F), Vec2f(71.3F, 66.8F), Vec2f(93.65F, 51.25F)}) {
    ImageU8 image(160, 120);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const Vec2f d = Vec2f(static_cast<float>(x), static_cast<float>(y)) - spot;
        const float grey = 20.0F + 200.0F * std::exp(-d.squaredNorm() / (2.0F * kSigma * kSigma));
        image.at(x, y) = static_cast<std::uint8_t>(std::lround(grey));
      }
    }
    ScalePyramid pyramid(kShape);
    pyramid.build(image.view());
    for (int l = 0; l < pyramid.levels(); ++l) {
      const Vec2f sharp = pyramid.toLevel0(l, centroid(pyramid.level(l), 20));
      const Vec2f smooth = pyramid.toLevel0(l, centroid(pyramid.smoothed(l), 20));
      EXPECT_LT((sharp - spot).norm(), 0.1F) << l;
      EXPECT_LT((smooth - spot).norm(), 0.1F) << l;
    }
  }
}

TEST(ScalePyramid, GivesTheSameLevelsAgainAfterAnotherSize) {
  const test::DeadLeaves leaves(9);
  const ImageU8 image = leaves.render(200, 150), other = leaves.render(333, 77);
  ScalePyramid fresh(kShape), used(kShape);
  fresh.build(image.view());
  used.build(other.view());
  used.build(image.view());
  ASSERT_EQ(fresh.levels(), used.levels());
  for (int l = 0; l < fresh.levels(); ++l) {
    const ImageViewU8 a = fresh.smoothed(l), b = used.smoothed(l);
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    for (int y = 0; y < a.height; ++y)
      EXPECT_TRUE(std::equal(a.row(y), a.row(y) + a.width, b.row(y)));
  }
}

}  // namespace
}  // namespace glide
