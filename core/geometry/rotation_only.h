#pragma once

#include "geometry/ray_pair.h"

#include <span>

namespace glide {

/// Rotation R_b_a that maps the bearings of view a onto those of view b best, with Tukey's weight
/// on the transfer error in pixels; `start` is a first guess.
Eigen::Quaterniond fitRotation(const Eigen::Quaterniond& start,
                               std::span<const RayPair> pairs,
                               double sigma_px);

/// Transfer error of a pair under a rotation, in pixels of view b.
Vec2d rotationError(const Eigen::Quaterniond& R_b_a, const RayPair& pair);

}  // namespace glide
