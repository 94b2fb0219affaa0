#include "feature/corner_orientation.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "feature/corner_orientation.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GLIDE_FEATURE_CORNER_ORIENTATION_ONCE
#define GLIDE_FEATURE_CORNER_ORIENTATION_ONCE
namespace glide {
namespace {

constexpr int kRows = 2 * kPatchRadius + 1;
/// Columns -kPatchRadius.., one more than needed: a whole number of vectors.
constexpr int kColumns = 32;

struct alignas(64) CentroidWeights {
  std::array<std::array<std::int16_t, kColumns>, kRows> mass{};   ///< R^2 - r^2 inside the disc
  std::array<std::array<std::int16_t, kColumns>, kRows> lever{};  ///< mass times column
};

constexpr CentroidWeights makeWeights() {
  CentroidWeights weights;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    for (int u = -kPatchRadius; u <= kPatchRadius; ++u) {
      const int mass = kPatchRadius * kPatchRadius - u * u - v * v;
      if (mass <= 0) continue;
      const std::size_t row = static_cast<std::size_t>(v + kPatchRadius);
      const std::size_t column = static_cast<std::size_t>(u + kPatchRadius);
      weights.mass[row][column] = static_cast<std::int16_t>(mass);
      weights.lever[row][column] = static_cast<std::int16_t>(mass * u);
    }
  }
  return weights;
}
constexpr CentroidWeights kWeights = makeWeights();

}  // namespace
}  // namespace glide
#endif

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

float centroidAngle(const ImageViewU8& image, const Corner& corner) {
  const hn::CappedTag<std::int16_t, kColumns> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d_pixel;
  const hn::RepartitionToWide<decltype(d)> d_sum;
  auto moment_x = hn::Zero(d_sum), spare_x = moment_x, moment_y = moment_x;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    const std::uint8_t* pixels = image.row(corner.y + v) + corner.x - kPatchRadius;
    const std::size_t row = static_cast<std::size_t>(v + kPatchRadius);
    auto row_sum = hn::Zero(d_sum), spare = row_sum;
    for (std::size_t u = 0; u < kColumns; u += hn::Lanes(d)) {
      const auto value = hn::PromoteTo(d, hn::LoadU(d_pixel, pixels + u));
      const auto lever = hn::Load(d, kWeights.lever[row].data() + u);
      const auto mass = hn::Load(d, kWeights.mass[row].data() + u);
      moment_x = hn::ReorderWidenMulAccumulate(d_sum, value, lever, moment_x, spare_x);
      row_sum = hn::ReorderWidenMulAccumulate(d_sum, value, mass, row_sum, spare);
    }
    moment_y = hn::Add(moment_y, hn::Mul(hn::Add(row_sum, spare), hn::Set(d_sum, v)));
  }
  const std::int32_t x = hn::GetLane(hn::SumOfLanes(d_sum, hn::Add(moment_x, spare_x)));
  const std::int32_t y = hn::GetLane(hn::SumOfLanes(d_sum, moment_y));
  return std::atan2(static_cast<float>(y), static_cast<float>(x));
}

void cornerAnglesImpl(const ImageViewU8& image,
                      std::span<const Corner> corners,
                      std::span<float> angles) {
  for (std::size_t i = 0; i < corners.size(); ++i) angles[i] = centroidAngle(image, corners[i]);
}

}  // namespace
}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {

HWY_EXPORT(cornerAnglesImpl);

void cornerAngles(const ImageViewU8& image,
                  std::span<const Corner> corners,
                  std::span<float> angles) {
  assert(corners.size() == angles.size());
  HWY_DYNAMIC_DISPATCH(cornerAnglesImpl)(image, corners, angles);
}

}  // namespace glide
#endif
