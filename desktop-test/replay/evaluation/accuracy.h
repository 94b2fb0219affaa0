#pragma once

#include "replay/evaluation/trajectory.h"

#include "geometry/lie.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glide::replay {

/// Indices of two poses that were taken at the same time.
struct PosePair {
  std::size_t truth = 0;
  std::size_t estimate = 0;
};

/// Pairs poses as evo does, so that the numbers agree: for each pose of the shorter trajectory (the
/// estimate when equal) the nearest one in time of the longer, the earlier on a tie, if it is at
/// most 10 ms away. A pose of the longer one may serve twice.
std::vector<PosePair> associate(const Trajectory& truth, const Trajectory& estimate);

/// Absolute trajectory error after Sim(3) alignment (Umeyama) of the estimate to the truth.
struct AbsoluteError {
  double rmse_m = 0.0;
  double max_m = 0.0;
  double scale = 1.0;  ///< metres per unit of the estimate
};
/// Nothing when fewer than three poses match or their positions are collinear.
std::optional<AbsoluteError> absoluteError(const Trajectory& truth, const Trajectory& estimate);

/// Relative pose error over one second: RMSE over all pairs of matched poses (i, j) where j is the
/// one nearest to t_i + 1 s, at most 0.1 s off, while the trajectory lasts that long. Translations
/// of the estimate are multiplied by scale.
struct RelativeError {
  double trans_m = 0.0;
  double rot_deg = 0.0;
  int pairs = 0;
};
std::optional<RelativeError> relativeError(const Trajectory& truth,
                                           const Trajectory& estimate,
                                           double scale);

/// What stats.json says about accuracy. All in the truth's unit.
struct Accuracy {
  std::string truth_file;
  int matched = 0;  ///< poses of the final trajectory with a truth
  std::optional<AbsoluteError> final_error;
  std::optional<AbsoluteError> live_error;
  std::optional<AbsoluteError> keyframe_error;
  std::optional<RelativeError> relative_error;
};

}  // namespace glide::replay
