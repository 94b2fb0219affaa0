#include "synthetic/sensor.h"

#include "synthetic/random.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

namespace {

/// About normal with unit variance: the sum of four uniform numbers (Irwin-Hall), ample for a
/// sensor.
float nearlyGaussian(std::uint64_t bits) {
  constexpr float kScale = 1.7320508F / 65536.0F;  // sqrt(12 / 4) over the range of one number
  const std::uint64_t sum =
      (bits & 0xFFFFU) + ((bits >> 16) & 0xFFFFU) + ((bits >> 32) & 0xFFFFU) + (bits >> 48);
  return (static_cast<float>(sum) - 2.0F * 65535.0F) * kScale;
}

}  // namespace

Exposure exposureAt(const Sensor& sensor, double share, std::uint64_t frame_seed) {
  const double gain = sensor.gain_begin * std::pow(sensor.gain_end / sensor.gain_begin, share);
  const double flicker = 2.0 * Random(frame_seed).uniform() - 1.0;
  return {gain * (1.0 + sensor.flicker * flicker),
          sensor.bias_begin + share * (sensor.bias_end - sensor.bias_begin)};
}

void develop(const ImageF& radiance,
             const Exposure& exposure,
             double noise,
             std::uint64_t frame_seed,
             ImageU8* out) {
  const auto gain = static_cast<float>(exposure.gain), bias = static_cast<float>(exposure.bias);
  const auto sigma = static_cast<float>(noise);
  Random random(frame_seed + 1);
  out->resize(radiance.width(), radiance.height());
  for (int y = 0; y < radiance.height(); ++y) {
    const float* in = radiance.row(y);
    std::uint8_t* row = out->row(y);
    for (int x = 0; x < radiance.width(); ++x) {
      const float noise_level = sigma > 0.0F ? sigma * nearlyGaussian(random.next()) : 0.0F;
      const float level = gain * in[x] + bias + noise_level;
      row[x] = static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
    }
  }
}

}  // namespace glide::synthetic
