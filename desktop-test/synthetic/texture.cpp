#include "synthetic/texture.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

namespace {

constexpr float kFixedPoint =
    256.0F;  // sub-levels per grey level, so that a gain of 2 shows no steps

/// Halves an image by 2x2 averages; the last row or column of an odd size is repeated.
ImageF halve(const ImageF& image) {
  ImageF half((image.width() + 1) / 2, (image.height() + 1) / 2);
  for (int y = 0; y < half.height(); ++y) {
    const float* top = image.row(2 * y);
    const float* bottom = image.row(std::min(2 * y + 1, image.height() - 1));
    for (int x = 0; x < half.width(); ++x) {
      const int left = 2 * x, right = std::min(2 * x + 1, image.width() - 1);
      half.row(y)[x] = 0.25F * (top[left] + top[right] + bottom[left] + bottom[right]);
    }
  }
  return half;
}

}  // namespace

Texture::Texture(const ImageF& radiance) {
  appendLevel(radiance);
  ImageF half = halve(radiance);
  while (half.width() > 1 || half.height() > 1) {
    appendLevel(half);
    half = halve(half);
  }
  appendLevel(half);
}

void Texture::appendLevel(const ImageF& image) {
  levels_.push_back({image.width(), image.height(), texels_.size()});
  for (int y = 0; y < image.height(); ++y) {
    const float* row = image.row(y);
    for (int x = 0; x < image.width(); ++x) {
      const float level = std::clamp(row[x], 0.0F, 255.0F);
      texels_.push_back(static_cast<std::uint16_t>(level * kFixedPoint + 0.5F));
    }
  }
}

float Texture::bilinear(const Level& level, float u, float v) const {
  const float x = std::clamp(u - 0.5F, 0.0F, static_cast<float>(level.width - 1));
  const float y = std::clamp(v - 0.5F, 0.0F, static_cast<float>(level.height - 1));
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.width - 1);
  const int y1 = std::min(y0 + 1, level.height - 1);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const std::uint16_t* top = texels_.data() + level.offset +
                             static_cast<std::size_t>(y0) * static_cast<std::size_t>(level.width);
  const std::uint16_t* bottom =
      texels_.data() + level.offset +
      static_cast<std::size_t>(y1) * static_cast<std::size_t>(level.width);
  const float a = static_cast<float>(top[x0]) + fx * static_cast<float>(top[x1] - top[x0]);
  const float b = static_cast<float>(bottom[x0]) + fx * static_cast<float>(bottom[x1] - bottom[x0]);
  return (a + fy * (b - a)) / kFixedPoint;
}

float Texture::sample(float u, float v, float footprint) const {
  if (footprint <= 1.0F) return bilinear(levels_[0], u, v);
  const float lod = std::log2(footprint);
  const auto fine = std::min(static_cast<std::size_t>(lod), levels_.size() - 1);
  const auto coarse = std::min(fine + 1, levels_.size() - 1);
  const float blend = lod - static_cast<float>(fine);
  const float scale = 1.0F / static_cast<float>(1U << fine);
  const float near = bilinear(levels_[fine], u * scale, v * scale);
  if (coarse == fine) return near;
  const float far = bilinear(levels_[coarse], 0.5F * u * scale, 0.5F * v * scale);
  return near + blend * (far - near);
}

}  // namespace glide::synthetic
