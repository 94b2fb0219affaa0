#pragma once

#include "geometry/camera_model.h"
#include "geometry/robust.h"

#include <optional>

namespace glide {

/// Norm of a reprojection residual (in sigmas) from which Huber's loss grows linearly: the square
/// root of the chi2 gate, so that what the gate keeps is weighted fully.
inline constexpr double kReprojectionHuber = 2.4476519360399260;
static_assert(kReprojectionHuber * kReprojectionHuber - kChi2_2 < 1e-12 &&
              kChi2_2 - kReprojectionHuber * kReprojectionHuber < 1e-12);

/// Norm (in sigmas) charged to an observation whose point does not project, so that costs of poses
/// can be compared: far beyond every inlier, yet no wall that one bad point puts in the way of all
/// others.
inline constexpr double kUnprojectableNorm = 100.0;

/// Of a residual's norm: Huber from kReprojectionHuber on, or the square alone.
enum class Loss { huber, squared };

/// r = (pi(p_cam) - uv) * inv_sigma, in sigmas, with its derivative by the camera point.
struct Reprojection {
  Vec2d r;
  Mat23d J_r_point;
};

/// Nothing when the point does not project or a number is not finite.
std::optional<Vec2d> reprojectionResidual(const CameraModel& camera,
                                          const Vec3d& p_cam,
                                          const Vec2d& uv,
                                          double inv_sigma);
std::optional<Reprojection> linearizeReprojection(const CameraModel& camera,
                                                  const Vec3d& p_cam,
                                                  const Vec2d& uv,
                                                  double inv_sigma);

/// Chain rule for T_cam_world <- exp(delta) * T_cam_world, delta = (translation, rotation):
/// J_r_point * [ I | -[p_cam]x ].
Mat26d leftPoseJacobian(const Mat23d& J_r_point, const Vec3d& p_cam);

}  // namespace glide
