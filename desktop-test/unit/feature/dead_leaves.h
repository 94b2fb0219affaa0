#pragma once

#include "geometry/eigen_types.h"
#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace glide::test {

/// An endless-looking collage of opaque rectangles ("dead leaves", Lee, Mumford and Huang 2001):
/// many corners of all sizes, seen under any affine view with the exact warp known.
class DeadLeaves {
 public:
  explicit DeadLeaves(unsigned seed) : canvas_(kSide, kSide) {
    std::mt19937 rng(seed);
    for (int y = 0; y < kSide; ++y) std::fill_n(canvas_.row(y), kSide, std::uint8_t{128});
    for (int i = 0; i < kLeaves; ++i) paintLeaf(&rng);
  }

  /// Pixel p of the image shows the point A * (p - centre) + middle of the collage, averaged over
  /// the pixel; contrast 1 keeps grey levels, smaller ones pull them towards mid grey. The collage
  /// is 512 pixels wide and high; its edges go on outside.
  ImageU8 render(int width, int height, const Eigen::Matrix2f& A, float contrast) const {
    ImageU8 image(width, height);
    const Eigen::Matrix2f A_canvas = kOversampling * A;
    const Vec2f middle = Vec2f::Constant(0.5F * kSide);
    const Vec2f centre(0.5F * static_cast<float>(width - 1), 0.5F * static_cast<float>(height - 1));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Vec2f off = Vec2f(static_cast<float>(x), static_cast<float>(y)) - centre;
        const float grey = average(A_canvas * off + middle, A_canvas);
        image.row(y)[x] = static_cast<std::uint8_t>(std::lround(128.0F + contrast * (grey - 128)));
      }
    }
    return image;
  }

  ImageU8 render(int width, int height) const {
    return render(width, height, Eigen::Matrix2f::Identity(), 1.0F);
  }

 private:
  static constexpr int kOversampling = 3;  ///< canvas pixels per unit
  static constexpr int kSide = 512 * kOversampling;
  static constexpr int kLeaves = 2500;
  static constexpr float kSmallestLeaf = 12.0F;  ///< half length, canvas pixels

  static float uniform(std::mt19937* rng) {
    return static_cast<float>((*rng)() >> 8U) / static_cast<float>(1U << 24U);
  }

  void paintLeaf(std::mt19937* rng) {
    const float half_u = kSmallestLeaf / std::sqrt(0.02F + uniform(rng));
    const float half_v = half_u * (0.3F + 0.7F * uniform(rng));
    const Vec2f center(kSide * uniform(rng), kSide * uniform(rng));
    const float angle = 3.14159265F * uniform(rng);
    const float c = std::cos(angle), s = std::sin(angle);
    const auto grey = static_cast<std::uint8_t>(256.0F * uniform(rng));
    const float reach = std::hypot(half_u, half_v);
    const auto low = [](float v) { return std::max(0, static_cast<int>(v)); };
    const auto high = [](float v) { return std::min(kSide, static_cast<int>(v)); };
    for (int y = low(center.y() - reach); y < high(center.y() + reach); ++y) {
      std::uint8_t* row = canvas_.row(y);
      const float dy = static_cast<float>(y) - center.y();
      for (int x = low(center.x() - reach); x < high(center.x() + reach); ++x) {
        const float dx = static_cast<float>(x) - center.x();
        if (std::abs(c * dx + s * dy) < half_u && std::abs(c * dy - s * dx) < half_v) row[x] = grey;
      }
    }
  }

  /// Mean grey level of a pixel around `center` on the canvas.
  float average(const Vec2f& center, const Eigen::Matrix2f& A_canvas) const {
    int sum = 0;
    for (int part = 0; part < kOversampling * kOversampling; ++part) {
      const float u = subPixel(part % kOversampling), v = subPixel(part / kOversampling);
      const float x = center.x() + A_canvas(0, 0) * u + A_canvas(0, 1) * v;
      const float y = center.y() + A_canvas(1, 0) * u + A_canvas(1, 1) * v;
      sum += canvas_.row(onCanvas(y))[onCanvas(x)];
    }
    return static_cast<float>(sum) / (kOversampling * kOversampling);
  }

  static int onCanvas(float coordinate) {
    return static_cast<int>(std::clamp(coordinate, 0.0F, static_cast<float>(kSide - 1)));
  }

  /// Centre of one of the parts of a pixel, from the pixel's centre.
  static float subPixel(int part) {
    return (static_cast<float>(part) + 0.5F) / kOversampling - 0.5F;
  }

  ImageU8 canvas_;
};

/// Rotation by `angle` (radians) and scale: maps pixels of a view that is turned and magnified.
inline Eigen::Matrix2f similarity(float angle, float scale) {
  Eigen::Matrix2f A;
  A << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return scale * A;
}

/// Adds Gaussian noise of `sigma` grey levels.
inline void addNoise(float sigma, unsigned seed, ImageU8* image) {
  std::mt19937 rng(seed);
  std::normal_distribution<float> noise(0.0F, sigma);
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) {
      const float grey = static_cast<float>(image->at(x, y)) + noise(rng);
      image->at(x, y) = static_cast<std::uint8_t>(std::clamp(grey, 0.0F, 255.0F));
    }
  }
}

}  // namespace glide::test
