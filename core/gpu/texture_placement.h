#pragma once

#include "glide/frame.h"
#include "glide/result.h"

#include <array>

namespace glide {

/// Size of the frames, px.
struct FrameSize {
  int width = 0, height = 0;
};

/// Where the pixels of a frame lie in a texture, in texture coordinates: pixel (x, y) is sampled at
/// origin + x * per_column + y * per_row.
struct TexturePlacement {
  std::array<float, 2> origin{}, per_column{}, per_row{};
  /// Every pixel is the centre of a texel (also mirrored or turned by quarters): no filter may
  /// touch it.
  bool hits_texels = false;
};

/// What Texture::transform says for frames of that size. The texture passed checkPlacement.
TexturePlacement placeTexture(const Texture& texture, FrameSize frame);

/// invalid_argument naming what is wrong: no name, another target than 2D and external, no size, a
/// transform that is not affine, stretches the texture in one direction, or leaves it.
Status checkPlacement(const Texture& texture, FrameSize frame);

}  // namespace glide
