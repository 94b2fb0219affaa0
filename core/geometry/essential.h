#pragma once

#include "geometry/lie.h"
#include "geometry/ray_pair.h"

#include <array>

namespace glide {

/// E = [t] R of a relative pose: bearing_b^T E bearing_a = 0.
Mat3d essentialOf(const SE3d& T_b_a);

/// Squared Sampson error of a pair in pixels^2: to first order the squared distance by which the
/// two pixels must move together to fit E. Chi-squared with one degree of freedom times sigma_px^2.
double sampsonSquared(const Mat3d& E, const RayPair& pair);

/// The four poses of an essential matrix, translations of unit length: (R1, t) (R1, -t) (R2, t)
/// (R2, -t). Hartley and Zisserman, section 9.6.2.
std::array<SE3d, 4> posesOfEssential(const Mat3d& E);

}  // namespace glide
