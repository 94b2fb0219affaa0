#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "geometry/sim3_ransac.h"

#include <optional>
#include <span>
#include <vector>

namespace glide {

using Mat47d = Eigen::Matrix<double, 4, 7>;

/// Both reprojection errors of a pair in sigmas, that in a first, and their derivative for
/// S_a_b <- exp(delta) * S_a_b, delta = (translation, rotation, log scale).
struct Sim3Residual {
  Vec4d r;
  Mat47d J_r_sim;
};

/// Nothing when either point does not project or a number is not finite.
std::optional<Sim3Residual> linearizeSim3(const CameraModel& camera,
                                          const Sim3d& S_a_b,
                                          const Sim3Pair& pair);

struct Sim3Estimate {
  Sim3d S_a_b;
  std::vector<bool> inlier;  ///< per pair, within the gate in both images
  int inliers = 0;
  double rms_px = 0.0;  ///< of the inliers' errors in an image, in units of their sigma
  bool valid = false;   ///< at least 6 inliers and a finite, well-conditioned solution
};

/// Refines a similarity on the bidirectional reprojection errors: damped Gauss-Newton on the 7x7
/// system, Huber, rounds with a chi2 gate in which outliers may come back.
/// `max_error2` is the gate, sigma^2. docs/algorithms/loop-closing.md.
Sim3Estimate optimizeSim3(const CameraModel& camera,
                          std::span<const Sim3Pair> pairs,
                          const Sim3d& S_a_b_guess,
                          double max_error2);

}  // namespace glide
