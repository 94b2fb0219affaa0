#pragma once

#include "geometry/lie.h"
#include "geometry/ray_pair.h"

#include <span>

namespace glide {

/// A relative pose and what the pairs say about its precision.
struct RefinedPose {
  SE3d T_b_a;                  ///< translation of unit length
  double direction_std = 0.0;  ///< of the translation's direction along its worst axis, radians
};

/// Sampson error of a pair in pixels (signed) and its derivative by (left rotation, two axes of the
/// translation's direction as tangentBasis() gives them).
struct SampsonResidual {
  double error = 0.0;
  Eigen::Matrix<double, 1, 5> J_error_pose;
};
SampsonResidual sampsonResidual(const SE3d& T_b_a, const RayPair& pair);

/// Two unit vectors perpendicular to a unit direction and to each other.
Mat32d tangentBasis(const Vec3d& direction);

/// Iterated least squares of the Sampson error over rotation and direction of translation. Tukey's
/// weight, whose scale shrinks to `sigma_px` so that a coarse start is enough, limits the error's
/// influence, a Mallows weight that of the geometry (Hampel et al., "Robust Statistics",
/// section 6.3).
RefinedPose refineEpipolar(const SE3d& T_b_a, std::span<const RayPair> pairs, double sigma_px);

}  // namespace glide
