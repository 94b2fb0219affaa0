#pragma once

#include "image/image.h"

#include <cmath>

namespace glide::test {

/// A float image of long waves, without quantisation: its central differences and its bilinear
/// interpolation are nearly exact. `phase` makes a different one.
inline ImageF smoothImage(int width, int height, double phase) {
  ImageF image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double waves = std::sin(0.11 * x + 0.05 * y + phase) + std::cos(0.07 * x - 0.12 * y) +
                           std::sin(0.002 * x * y + 2.0 * phase);
      image.at(x, y) = static_cast<float>(128.0 + 35.0 * waves);
    }
  }
  return image;
}

}  // namespace glide::test
