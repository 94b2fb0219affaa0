#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

namespace glide {

/// T_cam_world as Ceres stores it: q_xyzw, t_xyz.
inline constexpr int kPoseSize = 7;
Vec7d toPoseBlock(const SE3d& T_cam_world);
SE3d fromPoseBlock(const double* block);

/// Poses change by T <- exp(delta) * T, delta = (translation, rotation).
/// ReprojectionCost gives its derivative by delta in the first six of the seven columns, so
/// plusJacobian is [I; 0]: right for that cost only, and it spares the detour over the quaternion's
/// derivative.
class LeftPoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return kPoseSize; }
  int TangentSize() const override { return kPoseSize - 1; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

/// One observation's residual in sigmas by pose block and world point. A point that does not
/// project costs kUnprojectableNorm without a gradient, so that one bad point cannot stop the
/// solve.
class ReprojectionCost final : public ceres::SizedCostFunction<2, kPoseSize, 3> {
 public:
  /// `camera` outlives the cost.
  ReprojectionCost(const CameraModel& camera, const Vec2d& uv, double inv_sigma)
      : camera_(&camera), uv_(uv), inv_sigma_(inv_sigma) {}

  bool Evaluate(const double* const* parameters,
                double* residual,
                double** jacobians) const override;

 private:
  const CameraModel* camera_;
  Vec2d uv_;
  double inv_sigma_;
};

}  // namespace glide
