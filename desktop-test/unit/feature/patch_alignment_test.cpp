#include "feature/patch_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide {
namespace {

/// A smooth corner-like texture, in grey levels.
double texture(double x, double y) {
  return 128.0 + 50.0 * std::sin(0.55 * x + 0.2 * y) + 45.0 * std::cos(0.5 * y - 0.15 * x + 0.4);
}

/// The patch of a camera that sees texture point A * (pixel - corner) at each pixel.
FeaturePatch makePatch(const Vec2f& offset, const Eigen::Matrix2f& A_texture_patch, double gain) {
  FeaturePatch patch;
  for (int y = 0; y < FeaturePatch::kSize; ++y)
    for (int x = 0; x < FeaturePatch::kSize; ++x) {
      const Vec2f d =
          Vec2f(static_cast<float>(x), static_cast<float>(y)) - FeaturePatch::centre() - offset;
      const Vec2f at = A_texture_patch * d;
      const double grey = gain * texture(at.x(), at.y());
      patch.pixels[static_cast<std::size_t>(y * FeaturePatch::kSize + x)] =
          static_cast<std::uint8_t>(std::lround(grey));
    }
  patch.offset = offset;
  return patch;
}

const Eigen::Matrix2f kIdentity = Eigen::Matrix2f::Identity();

TEST(AlignPatch, FindsTheTrueCornerWhenTheDetectedOneIsOff) {
  const FeaturePatch source = makePatch({0.2F, -0.3F}, kIdentity, 1.0);
  FeaturePatch target = makePatch({-0.4F, 0.1F}, kIdentity, 1.0);
  target.offset = {0.5F, -0.6F};  // what a detector said
  const auto offset = alignPatch(source, target, kIdentity);
  ASSERT_TRUE(offset.has_value());
  EXPECT_NEAR(offset->x(), -0.4F, 0.05F);
  EXPECT_NEAR(offset->y(), 0.1F, 0.05F);
}

TEST(AlignPatch, UndoesRotationAndScale) {
  Eigen::Matrix2f A_target_source = Eigen::Rotation2Df(0.4F).toRotationMatrix() * 1.15F;
  const FeaturePatch source = makePatch({0.0F, 0.0F}, kIdentity, 1.0);
  FeaturePatch target = makePatch({0.3F, 0.4F}, A_target_source.inverse(), 1.0);
  target.offset = {-0.2F, 0.0F};
  const auto offset = alignPatch(source, target, A_target_source);
  ASSERT_TRUE(offset.has_value());
  EXPECT_NEAR(offset->x(), 0.3F, 0.05F);
  EXPECT_NEAR(offset->y(), 0.4F, 0.05F);
}

TEST(AlignPatch, IgnoresTheExposure) {
  const FeaturePatch source = makePatch({0.0F, 0.0F}, kIdentity, 1.0);
  FeaturePatch target = makePatch({0.6F, -0.5F}, kIdentity, 0.6);
  target.offset = {0.0F, 0.0F};
  const auto offset = alignPatch(source, target, kIdentity);
  ASSERT_TRUE(offset.has_value());
  EXPECT_NEAR(offset->x(), 0.6F, 0.06F);
  EXPECT_NEAR(offset->y(), -0.5F, 0.06F);
}

TEST(AlignPatch, RefusesAnotherTexture) {
  const FeaturePatch source = makePatch({0.0F, 0.0F}, kIdentity, 1.0);
  const FeaturePatch target =
      makePatch({0.0F, 0.0F}, Eigen::Rotation2Df(1.6F).toRotationMatrix(), 1.0);
  EXPECT_FALSE(alignPatch(source, target, kIdentity).has_value());
}

TEST(AlignPatch, RefusesABlankPatchAndAnEdge) {
  const FeaturePatch source = makePatch({0.0F, 0.0F}, kIdentity, 1.0);
  FeaturePatch blank;
  EXPECT_FALSE(alignPatch(blank, source, kIdentity).has_value());
  EXPECT_FALSE(alignPatch(source, blank, kIdentity).has_value());
  FeaturePatch edge;
  for (std::size_t i = 0; i < edge.pixels.size(); ++i)
    edge.pixels[i] = i % FeaturePatch::kSize < 8 ? 40 : 200;
  EXPECT_FALSE(alignPatch(edge, edge, kIdentity).has_value());
}

TEST(AlignPatch, RefusesAWarpThatLeavesThePatch) {
  const FeaturePatch source = makePatch({0.0F, 0.0F}, kIdentity, 1.0);
  const Eigen::Matrix2f shrink = kIdentity * 0.3F;
  EXPECT_FALSE(alignPatch(source, source, shrink).has_value());
}

}  // namespace
}  // namespace glide
