#pragma once

#include <array>
#include <cstdint>

namespace glide {

/// One bit of the descriptor: is the smoothed image darker at a than at b? Offsets from the corner
/// in px of its level, both inside the disc of kPatchRadius.
struct DescriptorTest {
  std::int8_t ax = 0, ay = 0, bx = 0, by = 0;
};

/// Radius of the disc that orientation and descriptor look at, px of the corner's level.
inline constexpr int kPatchRadius = 15;

/// The 256 tests for a corner whose orientation is 0; made by
/// desktop-test/support/make_descriptor_pattern.py, which says how.
extern const std::array<DescriptorTest, 256> kDescriptorPattern;

}  // namespace glide
