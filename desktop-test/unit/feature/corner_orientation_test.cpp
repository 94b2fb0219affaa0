#include "feature/corner_orientation.h"

#include "unit/feature/dead_leaves.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace glide {
namespace {

constexpr float kPi = 3.14159265F;

float naiveAngle(const ImageU8& image, const Corner& c) {
  double x = 0.0, y = 0.0;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    for (int u = -kPatchRadius; u <= kPatchRadius; ++u) {
      const int mass = kPatchRadius * kPatchRadius - u * u - v * v;
      if (mass <= 0) continue;
      x += mass * u * image.at(c.x + u, c.y + v);
      y += mass * v * image.at(c.x + u, c.y + v);
    }
  }
  return static_cast<float>(std::atan2(y, x));
}

float angleDifference(float a, float b) { return std::abs(std::remainder(a - b, 2.0F * kPi)); }

TEST(CornerAngles, PointUpTheBrightnessRamp) {
  ImageU8 image(60, 60);
  const std::vector<Corner> corner{{30, 29, 0}};
  for (const float angle : {-3.0F, -1.5F, 0.0F, 0.4F, 2.0F}) {
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {
        const float up = std::cos(angle) * static_cast<float>(x - 30) +
                         std::sin(angle) * static_cast<float>(y - 30);
        image.at(x, y) = static_cast<std::uint8_t>(std::lround(128.0F + 2.5F * up));
      }
    }
    std::vector<float> found(1);
    cornerAngles(image.view(), corner, found);
    EXPECT_LT(angleDifference(found[0], angle), 0.01F) << angle;
  }
}

TEST(CornerAngles, AreThoseOfTheWeightedCentroidOnEveryInstructionSet) {
  const ImageU8 image = test::DeadLeaves(3).render(101, 64);
  std::vector<Corner> corners;
  for (int x = 16; x < 101 - 16; ++x) corners.push_back({x, 16 + x % 32, 0});
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    std::vector<float> angles(corners.size());
    cornerAngles(image.view(), corners, angles);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_LT(angleDifference(angles[i], naiveAngle(image, corners[i])), 1e-5F) << i;
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace
}  // namespace glide
