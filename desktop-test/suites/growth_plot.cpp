#include "suites/growth_plot.h"

#include "plot/line_plot.h"

namespace glide::growth {

bool writePlot(const std::vector<Sample>& samples, const std::string& file) {
  if (samples.empty()) return false;
  plot::Curve keyframes, landmarks, memory;
  for (const Sample& sample : samples) {
    constexpr double kMinute = 60.0;  // s
    const double minutes = sample.t_s / kMinute;
    keyframes.points.push_back({minutes, static_cast<double>(sample.keyframes)});
    landmarks.points.push_back({minutes, static_cast<double>(sample.landmarks)});
    memory.points.push_back({minutes, sample.rss_mb});
  }
  return plot::write({{"keyframes", " min", {keyframes}},
                      {"landmarks", " min", {landmarks}},
                      {"resident memory, MB", " min", {memory}}},
                     file);
}

}  // namespace glide::growth
