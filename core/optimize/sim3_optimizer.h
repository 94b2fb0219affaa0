#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "geometry/sim3_ransac.h"

#include <optional>
#include <span>
#include <vector>

namespace glide {

using Vec5d = Eigen::Matrix<double, 5, 1>;
using Mat57d = Eigen::Matrix<double, 5, 7>;

/// The errors of a pair in sigmas and their derivative for S_a_b <- exp(delta) * S_a_b, delta =
/// (translation, rotation, log scale): p_b seen by a (2), p_a seen by b (2), and the logarithm of
/// the ratio of their distances from a.
struct Sim3Residual {
  Vec5d r;
  Mat57d J_r_sim;
};

/// Nothing when either point does not project or a number is not finite.
std::optional<Sim3Residual> linearizeSim3(const CameraModel& camera,
                                          const Sim3d& S_a_b,
                                          const Sim3Pair& pair);

struct Sim3Estimate {
  Sim3d S_a_b;
  std::vector<bool> inlier;  ///< per pair, each of its errors within the gate
  int inliers = 0;
  double rms_px = 0.0;  ///< of the inliers' errors in an image, in sigmas
  bool valid = false;   ///< at least 6 inliers and a finite, well-conditioned solution
};

/// Refines a similarity on the reprojection errors in both images and the distances: damped
/// Gauss-Newton on the 7x7 system, Huber, rounds with a gate of `max_error2` sigma^2 in which
/// outliers may come back. docs/algorithms/loop-closing.md.
Sim3Estimate optimizeSim3(const CameraModel& camera,
                          std::span<const Sim3Pair> pairs,
                          const Sim3d& S_a_b_guess,
                          double max_error2);

}  // namespace glide
