#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <optional>

namespace glide {

/// How a small patch around a point looks from elsewhere: maps pixel offsets in the source image to
/// pixel offsets in the target image, to first order, for a surface that faces the source camera.
/// Nothing where a ray or a projection does not exist.
std::optional<Mat2d> patchWarp(const CameraModel& camera,
                               const SE3d& T_target_source,
                               const Vec3d& p_source);

}  // namespace glide
