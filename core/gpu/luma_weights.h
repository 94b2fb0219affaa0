#pragma once

#include <array>

namespace glide {

/// What shaders/luma_weights.glsl weighs red, green and blue with; sums are 32768.
/// BT.601: 0.299, 0.587, 0.114, rounded as in OpenCV's cvtColor.
inline constexpr std::array<float, 3> kColourWeights{9798.0F, 19235.0F, 3735.0F};
/// Textures without green (R8, LUMINANCE8) hold the luma in red.
inline constexpr std::array<float, 3> kGreyWeights{32768.0F, 0.0F, 0.0F};

}  // namespace glide
