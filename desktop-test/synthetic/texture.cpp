#include "synthetic/texture.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

namespace {

constexpr float kFixedPoint =
    256.0F;  // sub-levels per grey level, so that a gain of 2 shows no steps

/// How a value lies in memory.
template <class Value>
struct Layout;
template <>
struct Layout<float> {
  static constexpr std::size_t kChannels = 1;
  static float channel(float value, std::size_t) { return value; }
  static float read(const std::uint16_t* texel) { return static_cast<float>(*texel); }
};
template <>
struct Layout<Vec3f> {
  static constexpr std::size_t kChannels = 3;
  static float channel(const Vec3f& value, std::size_t k) { return value[static_cast<int>(k)]; }
  static Vec3f read(const std::uint16_t* texel) {
    return {
        static_cast<float>(texel[0]), static_cast<float>(texel[1]), static_cast<float>(texel[2])};
  }
};

/// Halves an image by 2x2 averages; the last row or column of an odd size is repeated.
template <class Value>
Image<Value> halve(const Image<Value>& image) {
  Image<Value> half((image.width() + 1) / 2, (image.height() + 1) / 2);
  for (int y = 0; y < half.height(); ++y) {
    const Value* top = image.row(2 * y);
    const Value* bottom = image.row(std::min(2 * y + 1, image.height() - 1));
    for (int x = 0; x < half.width(); ++x) {
      const int left = 2 * x, right = std::min(2 * x + 1, image.width() - 1);
      half.row(y)[x] = 0.25F * (top[left] + top[right] + bottom[left] + bottom[right]);
    }
  }
  return half;
}

}  // namespace

Texture::Texture(const ImageF& radiance) { appendLevels(radiance); }
Texture::Texture(const ImageRgb& radiance) { appendLevels(radiance); }

template <class Value>
void Texture::appendLevels(const Image<Value>& radiance) {
  appendLevel(radiance);
  Image<Value> half = halve(radiance);
  while (half.width() > 1 || half.height() > 1) {
    appendLevel(half);
    half = halve(half);
  }
  appendLevel(half);
}

template <class Value>
void Texture::appendLevel(const Image<Value>& image) {
  levels_.push_back({image.width(), image.height(), texels_.size()});
  for (int y = 0; y < image.height(); ++y) {
    const Value* row = image.row(y);
    for (int x = 0; x < image.width(); ++x) {
      for (std::size_t k = 0; k < Layout<Value>::kChannels; ++k) {
        const float level = std::clamp(Layout<Value>::channel(row[x], k), 0.0F, 255.0F);
        texels_.push_back(static_cast<std::uint16_t>(level * kFixedPoint + 0.5F));
      }
    }
  }
}

template <class Value>
Value Texture::bilinear(const Level& level, float u, float v) const {
  constexpr std::size_t kChannels = Layout<Value>::kChannels;
  const float x = std::clamp(u - 0.5F, 0.0F, static_cast<float>(level.width - 1));
  const float y = std::clamp(v - 0.5F, 0.0F, static_cast<float>(level.height - 1));
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.width - 1);
  const int y1 = std::min(y0 + 1, level.height - 1);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const auto texel = [&](int tx, int ty) {
    const auto index = static_cast<std::size_t>(ty) * static_cast<std::size_t>(level.width) +
                       static_cast<std::size_t>(tx);
    return Layout<Value>::read(texels_.data() + level.offset + kChannels * index);
  };
  const Value top = texel(x0, y0), bottom = texel(x0, y1);
  const Value a = top + fx * (texel(x1, y0) - top);
  const Value b = bottom + fx * (texel(x1, y1) - bottom);
  return (a + fy * (b - a)) / kFixedPoint;
}

template <class Value>
Value Texture::sample(float u, float v, float footprint) const {
  if (footprint <= 1.0F) return bilinear<Value>(levels_[0], u, v);
  const float lod = std::log2(footprint);
  const auto fine = std::min(static_cast<std::size_t>(lod), levels_.size() - 1);
  const auto coarse = std::min(fine + 1, levels_.size() - 1);
  const float blend = lod - static_cast<float>(fine);
  const float scale = 1.0F / static_cast<float>(1U << fine);
  const Value near = bilinear<Value>(levels_[fine], u * scale, v * scale);
  if (coarse == fine) return near;
  const Value far = bilinear<Value>(levels_[coarse], 0.5F * u * scale, 0.5F * v * scale);
  return near + blend * (far - near);
}

template float Texture::sample<float>(float, float, float) const;
template Vec3f Texture::sample<Vec3f>(float, float, float) const;

}  // namespace glide::synthetic
