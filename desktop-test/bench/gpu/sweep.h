#pragma once

#include "bench/gpu/measure.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace glide::gpubench {

/// One workload of a sweep.
struct SweepPoint {
  int points = 0, patch = 0;
  std::vector<double> frame_ms;  ///< upload + pyramid + track + readback, one a plan

  /// Patch pixels: what the work of an iteration is proportional to.
  double pixels() const { return 1.0 * points * patch * patch; }
};

/// Frame cost against points at one patch size, and against patch sizes at one number of points.
struct Sweep {
  nlohmann::ordered_json gpu;  ///< as in the report
  Workload workload;
  std::vector<GpuPlan> plans;
  std::vector<SweepPoint> points, patches;

  /// Whether no plan's cost grows faster than the patch pixels, from the least to the most and from
  /// each workload to the next.
  bool isLinear() const;
};

Result<Sweep> measureSweep(const GlCaps& caps, const Options& options);

nlohmann::ordered_json toJson(const Sweep& sweep);
std::string toMarkdown(const Sweep& sweep);

}  // namespace glide::gpubench
