#pragma once

#include "image/image.h"

#include <cstdint>
#include <vector>

namespace glide::synthetic {

/// A gray texture with mip levels, immutable. Coordinates are continuous texels: the first texel
/// covers [0, 1).
class Texture {
 public:
  Texture() = default;
  /// Values are clamped to 0..255.
  explicit Texture(const ImageF& radiance);

  /// Grey level around (u, v), averaged over about `footprint` texels in each direction.
  float sample(float u, float v, float footprint) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::size_t offset = 0;  ///< first texel in texels_
  };
  float bilinear(const Level& level, float u, float v) const;
  void appendLevel(const ImageF& image);

  std::vector<Level> levels_;
  std::vector<std::uint16_t> texels_;  ///< grey level times 256
};

}  // namespace glide::synthetic
