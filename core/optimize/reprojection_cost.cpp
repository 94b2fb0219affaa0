#include "optimize/reprojection_cost.h"

#include "optimize/residuals.h"

namespace glide {
namespace {

using RowMat27d = Eigen::Matrix<double, 2, kPoseSize, Eigen::RowMajor>;
using RowMat23d = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using RowMat76d = Eigen::Matrix<double, kPoseSize, kPoseSize - 1, Eigen::RowMajor>;
using RowMat67d = Eigen::Matrix<double, kPoseSize - 1, kPoseSize, Eigen::RowMajor>;

/// Either entry may be null: Ceres asks for no derivative by a fixed camera.
struct JacobianBlocks {
  double* pose;
  double* point;
};

void writeJacobians(const Mat23d& J_r_cam_point,
                    const Vec3d& p_cam,
                    const Mat3d& R_cam_world,
                    const JacobianBlocks& blocks) {
  if (blocks.pose != nullptr) {
    Eigen::Map<RowMat27d> J_r_pose(blocks.pose);
    J_r_pose.leftCols<6>() = leftPoseJacobian(J_r_cam_point, p_cam);
    J_r_pose.col(6).setZero();
  }
  if (blocks.point != nullptr) {
    Eigen::Map<RowMat23d>(blocks.point).noalias() = J_r_cam_point * R_cam_world;
  }
}

}  // namespace

Vec7d toPoseBlock(const SE3d& T_cam_world) {
  Vec7d block;
  block << T_cam_world.q.coeffs(), T_cam_world.t;
  return block;
}

SE3d fromPoseBlock(const double* block) {
  SE3d T_cam_world;
  T_cam_world.q = Eigen::Map<const Eigen::Quaterniond>(block);
  T_cam_world.t = Eigen::Map<const Vec3d>(block + 4);
  return T_cam_world;
}

bool LeftPoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const SE3d moved = SE3d::exp(Eigen::Map<const Vec6d>(delta)) * fromPoseBlock(x);
  Eigen::Map<Vec7d> block(x_plus_delta);
  block = toPoseBlock(moved);
  return block.allFinite();
}

bool LeftPoseManifold::PlusJacobian(const double*, double* jacobian) const {
  Eigen::Map<RowMat76d>(jacobian).setIdentity();
  return true;
}

bool LeftPoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vec6d> delta(y_minus_x);
  delta = (fromPoseBlock(y) * fromPoseBlock(x).inverse()).log();
  return delta.allFinite();
}

bool LeftPoseManifold::MinusJacobian(const double*, double* jacobian) const {
  Eigen::Map<RowMat67d>(jacobian).setIdentity();
  return true;
}

bool ReprojectionCost::Evaluate(const double* const* parameters,
                                double* residual,
                                double** jacobians) const {
  const SE3d T_cam_world = fromPoseBlock(parameters[0]);
  const Mat3d R_cam_world = T_cam_world.rotation();
  const Vec3d p_cam = R_cam_world * Eigen::Map<const Vec3d>(parameters[1]) + T_cam_world.t;
  Eigen::Map<Vec2d> r(residual);
  const Vec2d unprojectable(kUnprojectableNorm, 0.0);
  if (jacobians == nullptr) {
    r = reprojectionResidual(*camera_, p_cam, uv_, inv_sigma_).value_or(unprojectable);
    return true;
  }
  const Reprojection flat{unprojectable, Mat23d::Zero()};
  const Reprojection lin = linearizeReprojection(*camera_, p_cam, uv_, inv_sigma_).value_or(flat);
  r = lin.r;
  writeJacobians(lin.J_r_point, p_cam, R_cam_world, {jacobians[0], jacobians[1]});
  return true;
}

}  // namespace glide
