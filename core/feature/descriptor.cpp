#include "feature/descriptor.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace glide {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Orientations of the pattern: steps of 12 degrees as in the paper.
constexpr int kSteps = 30;

/// Half width of the orientation disc in each row, by distance of the row from the centre.
constexpr std::array<int, kPatchRadius + 1> makeDiscRows() {
  std::array<int, kPatchRadius + 1> half_width{};
  for (int v = 0; v <= kPatchRadius; ++v) {
    int u = 0;
    while ((u + 1) * (u + 1) + v * v <= kPatchRadius * kPatchRadius) ++u;
    half_width[static_cast<std::size_t>(v)] = u;
  }
  return half_width;
}
constexpr std::array<int, kPatchRadius + 1> kDiscRows = makeDiscRows();

DescriptorTest rotated(const DescriptorTest& test, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [](double value) { return static_cast<std::int8_t>(std::lround(value)); };
  return {turn(c * test.ax - s * test.ay),
          turn(s * test.ax + c * test.ay),
          turn(c * test.bx - s * test.by),
          turn(s * test.bx + c * test.by)};
}

}  // namespace

float centroidAngle(const ImageViewU8& image, int x, int y) {
  int moment_x = 0, moment_y = 0;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    const std::uint8_t* row = image.row(y + v) + x;
    const int half_width = kDiscRows[static_cast<std::size_t>(std::abs(v))];
    int row_sum = 0;
    for (int u = -half_width; u <= half_width; ++u) {
      row_sum += row[u];
      moment_x += u * row[u];
    }
    moment_y += v * row_sum;
  }
  return std::atan2(static_cast<float>(moment_y), static_cast<float>(moment_x));
}

SteeredPattern::SteeredPattern() {
  steered_.reserve(kSteps * kDescriptorPattern.size());
  for (int step = 0; step < kSteps; ++step) {
    const double angle = 2.0 * kPi * step / kSteps;
    for (const DescriptorTest& test : kDescriptorPattern) steered_.push_back(rotated(test, angle));
  }
}

Descriptor SteeredPattern::describe(const ImageViewU8& smooth, int x, int y, float angle) const {
  const double turns = static_cast<double>(angle) / (2.0 * kPi);
  const int step = (static_cast<int>(std::lround(turns * kSteps)) + kSteps) % kSteps;
  const DescriptorTest* test =
      steered_.data() + static_cast<std::size_t>(step) * kDescriptorPattern.size();
  const std::uint8_t* center = smooth.row(y) + x;
  const std::ptrdiff_t stride = smooth.stride;
  Descriptor descriptor{};
  for (std::uint64_t& word : descriptor) {
    for (unsigned bit = 0; bit < 64U; ++bit, ++test) {
      const bool darker =
          center[test->ay * stride + test->ax] < center[test->by * stride + test->bx];
      word |= std::uint64_t{darker} << bit;
    }
  }
  return descriptor;
}

}  // namespace glide
