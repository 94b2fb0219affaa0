#pragma once

#include "replay/evaluation/accuracy.h"
#include "replay/evaluation/trajectory.h"

#include "geometry/lie.h"

#include <optional>
#include <vector>

namespace glide::replay {

/// The ground truth laid over an estimate, by the Sim(3) of the evaluation (absoluteError).
struct AlignedTruth {
  Sim3d S_estimate_truth;
  std::vector<PosePair> pairs;  ///< that it was found with
  /// The truth while the estimate lasts, in the estimate's world; of no more than 2000 poses, for a
  /// picture does not tell more apart.
  Trajectory path;
};

/// Nothing when fewer than three poses match or their positions are collinear.
std::optional<AlignedTruth> alignTruth(const Trajectory& truth, const Trajectory& estimate);

}  // namespace glide::replay
