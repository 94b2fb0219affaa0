#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

namespace glide {

/// `kCount` distinct indices below `size` (>= kCount), in random order. The same on every standard
/// library, unlike std::uniform_int_distribution; the modulo's bias is size / 2^64.
template <std::size_t kCount>
std::array<std::size_t, kCount> sampleDistinct(std::size_t size, std::mt19937_64& rng) {
  std::array<std::size_t, kCount> picked{};
  for (std::size_t i = 0; i < kCount;) {
    picked[i] = static_cast<std::size_t>(rng() % size);
    const auto end = picked.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(picked.begin(), end, picked[i]) == end) ++i;
  }
  return picked;
}

/// Samples after which one free of outliers has been drawn with a probability of 99.99 %.
inline int samplesNeeded(double inlier_share, std::size_t sample_size) {
  constexpr double kLogFailure = -9.21;  // ln 1e-4
  const double good = std::pow(inlier_share, static_cast<double>(sample_size));
  if (good >= 1.0) return 1;
  const double needed = good > 0.0 ? kLogFailure / std::log1p(-good) : kLogFailure;
  constexpr double kMany = 1e9;
  return good > 0.0 && needed < kMany ? static_cast<int>(std::ceil(needed))
                                      : std::numeric_limits<int>::max();
}

}  // namespace glide
