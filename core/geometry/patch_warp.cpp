#include "geometry/patch_warp.h"

namespace glide {
namespace {

// The patch is a few pixels wide: differences over its half width average the lens over it.
constexpr double kStep_px = 4.0;

}  // namespace

std::optional<Mat2d> patchWarp(const CameraModel& camera,
                               const SE3d& T_target_source,
                               const Vec3d& p_source) {
  const std::optional<Vec2d> uv_source = camera.project(p_source);
  const std::optional<Vec2d> uv_target = camera.project(T_target_source * p_source);
  if (!uv_source || !uv_target) return std::nullopt;
  const Vec3d normal = p_source.normalized();
  Mat2d A;
  for (int axis = 0; axis < 2; ++axis) {
    const std::optional<Vec3d> ray = camera.unproject(*uv_source + kStep_px * Vec2d::Unit(axis));
    if (!ray || ray->dot(normal) <= 0.0) return std::nullopt;
    const Vec3d p_plane = *ray * (p_source.norm() / ray->dot(normal));
    const std::optional<Vec2d> uv = camera.project(T_target_source * p_plane);
    if (!uv) return std::nullopt;
    A.col(axis) = (*uv - *uv_target) / kStep_px;
  }
  return A;
}

}  // namespace glide
