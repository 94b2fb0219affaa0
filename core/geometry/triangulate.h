#pragma once

#include "geometry/lie.h"

#include <optional>

namespace glide {

/// Point in frame a from two unit bearings: both are turned by the smallest angles (least squares
/// of their sines; the L2 method of Lee and Civera, "Closed-Form Optimal Two-View Triangulation
/// Based on Angular Errors", ICCV 2019) until they meet. Nothing when the rays are parallel, when
/// the point lies behind either camera along its ray, or when there is no baseline.
std::optional<Vec3d> triangulate(const SE3d& T_b_a, const Vec3d& bearing_a, const Vec3d& bearing_b);

/// Angle at which a point is seen from two camera centres, radians.
double parallaxAngle(const Vec3d& p, const Vec3d& center_a, const Vec3d& center_b);

}  // namespace glide
