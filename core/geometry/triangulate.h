#pragma once

#include <optional>

#include "geometry/lie.h"

namespace glide {

/// Point in frame a from two unit bearings; linear (two-ray least squares in the projective sense),
/// nothing when the rays are parallel or the point lies behind either camera.
std::optional<Vec3d> triangulate(const SE3d& T_b_a, const Vec3d& bearing_a, const Vec3d& bearing_b);

/// Angle at which a point is seen from two camera centres, radians.
double parallaxAngle(const Vec3d& p, const Vec3d& center_a, const Vec3d& center_b);

}  // namespace glide
