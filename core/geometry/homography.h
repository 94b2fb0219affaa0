#pragma once

#include "geometry/lie.h"
#include "geometry/ray_pair.h"

#include <optional>
#include <span>
#include <vector>

namespace glide {

/// Homography of bearings, bearing_b ~ H bearing_a, from at least four pairs: linear least squares
/// of the transfer error into view b in pixels. `pairs` and `weights` have one length. Nothing for
/// degenerate input. det H > 0.
std::optional<Mat3d> fitHomography(std::span<const RayPair* const> pairs,
                                   std::span<const double> weights);

/// Mean squared transfer error of both directions in pixels^2, halved: each transfer carries the
/// noise of two pixels. Chi-squared with two degrees of freedom times sigma_px^2. Infinite when a
/// ray is mapped behind the camera.
double transferSquared(const Mat3d& H, const Mat3d& H_inverse, const RayPair& pair);

/// The two relative poses (up to the sign of the translation, which is of unit length) that map a
/// plane by H = R + t n^T / d; empty when H is a rotation. Ma, Soatto, Kosecka and Sastry, "An
/// Invitation to 3-D Vision", section 5.3.3.
std::vector<SE3d> posesOfHomography(const Mat3d& H);

}  // namespace glide
