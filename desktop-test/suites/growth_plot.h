#pragma once

#include <string>
#include <vector>

namespace glide::growth {

/// The map and the process at one moment.
struct Sample {
  double t_s = 0.0;  ///< seconds of the sequence
  std::size_t keyframes = 0, landmarks = 0;
  double rss_mb = 0.0;  ///< resident memory now, MB
};

/// Keyframes, landmarks and memory over time, one above the other, as a PNG; whether it could be
/// written.
bool writePlot(const std::vector<Sample>& samples, const std::string& file);

}  // namespace glide::growth
