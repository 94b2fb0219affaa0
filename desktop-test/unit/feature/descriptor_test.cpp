#include "feature/descriptor.h"

#include "unit/feature/dead_leaves.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace glide {
namespace {

constexpr float kHalfPi = 1.57079633F;

/// The image turned by 90 degrees: pixel (x, y) moves to (height - 1 - y, x).
ImageU8 quarterTurn(const ImageU8& image) {
  ImageU8 turned(image.height(), image.width());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      turned.at(image.height() - 1 - y, x) = image.at(x, y);
    }
  }
  return turned;
}

TEST(DescriptorPattern, HasDifferentTestsInsideTheDisc) {
  std::set<std::tuple<int, int, int, int>> seen;
  for (const DescriptorTest& t : kDescriptorPattern) {
    EXPECT_LE(t.ax * t.ax + t.ay * t.ay, kPatchRadius * kPatchRadius);
    EXPECT_LE(t.bx * t.bx + t.by * t.by, kPatchRadius * kPatchRadius);
    EXPECT_TRUE(seen.emplace(t.ax, t.ay, t.bx, t.by).second);
  }
}

TEST(SteeredPattern, ComparesThePixelsOfThePatternWhenUpright) {
  const ImageU8 image = test::DeadLeaves(4).render(64, 64);
  const Descriptor d = SteeredPattern().describe(image.view(), 31, 33, 0.0F);
  for (unsigned i = 0; i < 256; ++i) {
    const DescriptorTest& t = kDescriptorPattern[i];
    const bool darker = image.at(31 + t.ax, 33 + t.ay) < image.at(31 + t.bx, 33 + t.by);
    EXPECT_EQ((d[i / 64] >> (i % 64)) & 1U, darker ? 1U : 0U) << i;
  }
}

TEST(SteeredPattern, TurnsWithTheImage) {
  const SteeredPattern pattern;
  const ImageU8 image = test::DeadLeaves(5).render(80, 70);
  const ImageU8 turned = quarterTurn(image);
  for (const float angle : {-3.1F, -1.0F, 0.3F, 1.5F}) {
    const Descriptor before = pattern.describe(image.view(), 40, 30, angle);
    const Descriptor after = pattern.describe(turned.view(), 70 - 1 - 30, 40, angle + kHalfPi);
    EXPECT_LE(descriptorDistance(before, after), 8) << angle;  // rounding of single offsets
  }
}

TEST(SteeredPattern, TakesAnglesFromAllTurns) {
  const SteeredPattern pattern;
  const ImageU8 image = test::DeadLeaves(6).render(64, 64);
  const Descriptor reference = pattern.describe(image.view(), 32, 32, 1.0F);
  for (const float turn : {-4.0F, -8.0F, 4.0F, 12.0F}) {
    const Descriptor again = pattern.describe(image.view(), 32, 32, 1.0F + turn * kHalfPi);
    EXPECT_EQ(descriptorDistance(reference, again), 0) << turn;
  }
}

}  // namespace
}  // namespace glide
