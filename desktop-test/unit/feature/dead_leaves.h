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
  /// the pixel; contrast 1 keeps grey levels, smaller ones pull them towards mid grey.
  ImageU8 render(int width, int height, const Eigen::Matrix2f& A, float contrast) const {
    ImageU8 image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const float grey = 128.0F + contrast * (average(A, offCentre(image, x, y)) - 128.0F);
        image.at(x, y) = static_cast<std::uint8_t>(std::lround(grey));
      }
    }
    return image;
  }

  ImageU8 render(int width, int height) const {
    return render(width, height, Eigen::Matrix2f::Identity(), 1.0F);
  }

 private:
  static constexpr int kOversampling = 4;  ///< canvas pixels per unit
  static constexpr int kSide = 2048;
  static constexpr int kLeaves = 2500;

  static Vec2f offCentre(const ImageU8& image, int x, int y) {
    return {static_cast<float>(x) - 0.5F * static_cast<float>(image.width() - 1),
            static_cast<float>(y) - 0.5F * static_cast<float>(image.height() - 1)};
  }

  static float uniform(std::mt19937* rng) {
    return static_cast<float>((*rng)() >> 8U) / static_cast<float>(1U << 24U);
  }

  void paintLeaf(std::mt19937* rng) {
    const float size = 16.0F / std::sqrt(0.02F + uniform(rng));
    const float half_x = size, half_y = size * (0.3F + 0.7F * uniform(rng));
    const Vec2f center(kSide * uniform(rng), kSide * uniform(rng));
    const float angle = 3.14159265F * uniform(rng);
    const Vec2f axis(std::cos(angle), std::sin(angle));
    const auto grey = static_cast<std::uint8_t>(256.0F * uniform(rng));
    const float reach = std::hypot(half_x, half_y);
    const auto low = [](float v) { return std::max(0, static_cast<int>(v)); };
    const auto high = [](float v) { return std::min(kSide, static_cast<int>(v)); };
    for (int y = low(center.y() - reach); y < high(center.y() + reach); ++y) {
      for (int x = low(center.x() - reach); x < high(center.x() + reach); ++x) {
        const Vec2f d = Vec2f(static_cast<float>(x), static_cast<float>(y)) - center;
        const float u = d.dot(axis), v = d.x() * axis.y() - d.y() * axis.x();
        if (std::abs(u) < half_x && std::abs(v) < half_y) canvas_.at(x, y) = grey;
      }
    }
  }

  float average(const Eigen::Matrix2f& A, const Vec2f& offset) const {
    int sum = 0;
    for (int j = 0; j < kOversampling; ++j) {
      for (int i = 0; i < kOversampling; ++i) {
        const Vec2f sub(subPixel(i), subPixel(j));
        const Vec2f at = kOversampling * (A * (offset + sub)) + Vec2f::Constant(0.5F * kSide);
        const int x = std::clamp(static_cast<int>(std::floor(at.x())), 0, kSide - 1);
        const int y = std::clamp(static_cast<int>(std::floor(at.y())), 0, kSide - 1);
        sum += canvas_.at(x, y);
      }
    }
    return static_cast<float>(sum) / (kOversampling * kOversampling);
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
