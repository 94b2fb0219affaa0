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

double meteredGain(const Sensor& sensor, double mean_radiance) {
  constexpr double kMiddle = 110.0;  // grey level of a well exposed image, on average
  constexpr double kDarkest = 10.0;  // below, the gain grows no more
  if (sensor.metering == 0.0) return 1.0;
  return std::pow(kMiddle / std::max(kDarkest, mean_radiance), sensor.metering);
}

namespace {

/// Gain, bias and noise of one frame.
class Developer {
 public:
  Developer(const Exposure& exposure, double noise, std::uint64_t frame_seed)
      : gain_(static_cast<float>(exposure.gain)),
        bias_(static_cast<float>(exposure.bias)),
        sigma_(static_cast<float>(noise)),
        random_(frame_seed + 1) {}

  std::uint8_t operator()(float radiance) {
    const float noise_level = sigma_ > 0.0F ? sigma_ * nearlyGaussian(random_.next()) : 0.0F;
    const float level = gain_ * radiance + bias_ + noise_level;
    return static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
  }

 private:
  const float gain_, bias_, sigma_;
  Random random_;
};

}  // namespace

void develop(const ImageF& radiance,
             const Exposure& exposure,
             double noise,
             std::uint64_t frame_seed,
             ImageU8* out) {
  Developer developed(exposure, noise, frame_seed);
  out->resize(radiance.width(), radiance.height());
  for (int y = 0; y < radiance.height(); ++y) {
    const float* in = radiance.row(y);
    std::uint8_t* row = out->row(y);
    for (int x = 0; x < radiance.width(); ++x) row[x] = developed(in[x]);
  }
}

void develop(const ImageRgb& radiance,
             const Exposure& exposure,
             double noise,
             std::uint64_t frame_seed,
             ImageU8* out) {
  Developer developed(exposure, noise, frame_seed);
  out->resize(3 * radiance.width(), radiance.height());
  for (int y = 0; y < radiance.height(); ++y) {
    const Vec3f* in = radiance.row(y);
    std::uint8_t* row = out->row(y);
    for (int x = 0; x < radiance.width(); ++x) {
      for (int k = 0; k < 3; ++k) row[3 * x + k] = developed(in[x][k]);
    }
  }
}

}  // namespace glide::synthetic
