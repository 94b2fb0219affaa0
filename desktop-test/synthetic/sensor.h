#pragma once

#include "synthetic/texture.h"

#include "image/image.h"

#include <cstdint>

namespace glide::synthetic {

/// How radiance becomes grey levels, over the whole sequence.
struct Sensor {
  double noise = 0.0;       ///< standard deviation, grey levels
  double shutter_s = 0.0;   ///< seconds of exposure: motion blur, 0 = none
  int shutter_samples = 8;  ///< renderings averaged over the exposure
  double gain_begin = 1.0,
         gain_end = 1.0;  ///< exposure gain, changes geometrically from first to last frame
  double bias_begin = 0.0, bias_end = 0.0;  ///< grey levels added, changes linearly
  double flicker = 0.0;                     ///< each frame's gain varies by up to this share
  double metering = 0.0;  ///< exponent by which the gain follows darker views, 0 = fixed, 1 = fully
  double readout_s = 0.0;  ///< seconds from the first to the last row: rolling shutter, 0 = global
};

/// Gain and bias of one frame.
struct Exposure {
  double gain = 1.0, bias = 0.0;
};

/// `share` runs from 0 at the first frame to 1 at the last.
Exposure exposureAt(const Sensor& sensor, double share, std::uint64_t frame_seed);

/// Gain that brings an image of this mean radiance (grey levels) near to the middle of the range,
/// as a camera that meters its exposure does; 1 when the sensor does not.
double meteredGain(const Sensor& sensor, double mean_radiance);

/// gain * radiance + bias + noise, rounded and clipped to 0..255.
void develop(const ImageF& radiance,
             const Exposure& exposure,
             double noise,
             std::uint64_t frame_seed,
             ImageU8* out);
/// The same for each colour. Red, green, blue side by side: three times as wide.
void develop(const ImageRgb& radiance,
             const Exposure& exposure,
             double noise,
             std::uint64_t frame_seed,
             ImageU8* out);

}  // namespace glide::synthetic
