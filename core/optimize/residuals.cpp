#include "optimize/residuals.h"

#include <cmath>

namespace glide {

std::optional<Vec2d> reprojectionResidual(const CameraModel& camera,
                                          const Vec3d& p_cam,
                                          const Vec2d& uv,
                                          double inv_sigma) {
  const std::optional<Vec2d> projected = camera.project(p_cam);
  if (!projected) return std::nullopt;
  const Vec2d r = (*projected - uv) * inv_sigma;
  if (!std::isfinite(r.squaredNorm())) return std::nullopt;
  return r;
}

std::optional<Reprojection> linearizeReprojection(const CameraModel& camera,
                                                  const Vec3d& p_cam,
                                                  const Vec2d& uv,
                                                  double inv_sigma) {
  const std::optional<Projection> projected = camera.projectWithJacobian(p_cam);
  if (!projected) return std::nullopt;
  const Vec2d r = (projected->uv - uv) * inv_sigma;
  if (!std::isfinite(r.squaredNorm())) return std::nullopt;
  return Reprojection{r, projected->J_uv_point * inv_sigma};
}

Mat26d leftPoseJacobian(const Mat23d& J_r_point, const Vec3d& p_cam) {
  // Row by row: a^T * -[p]x = (p x a)^T.
  Mat26d J_r_pose;
  for (int i = 0; i < 2; ++i) {
    const Vec3d a = J_r_point.row(i).transpose();
    J_r_pose.block<1, 3>(i, 0) = a.transpose();
    J_r_pose.block<1, 3>(i, 3) = p_cam.cross(a).transpose();
  }
  return J_r_pose;
}

}  // namespace glide
