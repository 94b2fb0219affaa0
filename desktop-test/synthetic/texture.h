#pragma once

#include "geometry/eigen_types.h"
#include "image/image.h"

#include <cstdint>
#include <type_traits>
#include <vector>

namespace glide::synthetic {

/// Red, green and blue, in the same unit as grey levels.
using ImageRgb = Image<Vec3f>;

/// No light.
template <class Value>
Value black() {
  if constexpr (std::is_same_v<Value, float>) {
    return 0.0F;
  } else {
    return Value::Zero();
  }
}

/// A texture with mip levels, immutable: gray, or in colour. Coordinates are continuous texels: the
/// first texel covers [0, 1).
class Texture {
 public:
  Texture() = default;
  /// Values are clamped to 0..255.
  explicit Texture(const ImageF& radiance);
  explicit Texture(const ImageRgb& radiance);

  /// Level around (u, v), averaged over about `footprint` texels in each direction. float of a gray
  /// texture, Vec3f of one in colour.
  template <class Value>
  Value sample(float u, float v, float footprint) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::size_t offset = 0;  ///< first texel in texels_
  };
  template <class Value>
  void appendLevels(const Image<Value>& radiance);
  template <class Value>
  void appendLevel(const Image<Value>& image);
  template <class Value>
  Value bilinear(const Level& level, float u, float v) const;

  std::vector<Level> levels_;
  std::vector<std::uint16_t> texels_;  ///< level times 256, the channels of a texel side by side
};

}  // namespace glide::synthetic
