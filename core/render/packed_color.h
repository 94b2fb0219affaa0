#pragma once

#include "glide/render_types.h"

#include <array>
#include <cstdint>

namespace glide {

/// Red, green, blue, alpha from 0 to 255.
using PackedColor = std::array<std::uint8_t, 4>;

/// Of a share; below 0 and above 1 as these.
inline std::uint8_t packChannel(float value) {
  constexpr float kMax = 255.0F;
  const float rounded = value * kMax + 0.5F;
  return static_cast<std::uint8_t>(rounded < 0.0F ? 0.0F : (rounded > kMax ? kMax : rounded));
}

inline PackedColor packColor(const Color& color) {
  return {
      packChannel(color[0]), packChannel(color[1]), packChannel(color[2]), packChannel(color[3])};
}

}  // namespace glide
