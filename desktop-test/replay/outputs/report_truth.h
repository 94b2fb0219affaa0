#pragma once

#include "replay/evaluation/trajectory.h"

#include <array>
#include <optional>
#include <vector>

namespace glide::replay {

/// The ground truth as the report shows it: in the map's world, by the Sim(3) of the evaluation.
struct ReportTruth {
  double meters_per_unit = 1.0;  ///< of the map
  /// The truth's path while the trajectory lasts, thinned for display, x y z after x y z.
  std::vector<float> path;
  /// For each pose of the trajectory the truth's position at its time; NaN where there is none.
  std::vector<std::array<float, 3>> matched;
};

/// Nothing when too few poses match to align the two.
std::optional<ReportTruth> reportTruth(const Trajectory& truth, const Trajectory& trajectory);

}  // namespace glide::replay
