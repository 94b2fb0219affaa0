#pragma once

#include <cstdint>

namespace glide::synthetic {

/// A well-mixed function of 64 bits (the finaliser of splitmix64, Steele et al., OOPSLA 2014).
inline std::uint64_t mixBits(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// Random numbers that are the same with every compiler and standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixBits(seed)) {}

  std::uint64_t next() { return mixBits(state_++); }

  /// In [0, 1).
  float uniform() {
    constexpr float kUnit = 1.0F / 16777216.0F;  // 2^-24: as many bits as a float holds
    return static_cast<float>(next() >> 40) * kUnit;
  }
  float uniform(float low, float high) { return low + (high - low) * uniform(); }

  /// In [0, count).
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

 private:
  std::uint64_t state_;
};

}  // namespace glide::synthetic
