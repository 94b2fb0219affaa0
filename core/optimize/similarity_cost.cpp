#include "optimize/similarity_cost.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glide {
namespace {

using RowMat78d = Eigen::Matrix<double, kSimilarityTangent, kSimilaritySize, Eigen::RowMajor>;
using RowMat87d = Eigen::Matrix<double, kSimilaritySize, kSimilarityTangent, Eigen::RowMajor>;

// B_n / n! for n = 2, 4, ..., 12; the odd ones are zero from n = 3 on.
constexpr std::array<double, 6> kEvenBernoulli{1.0 / 12.0,
                                               -1.0 / 720.0,
                                               1.0 / 30240.0,
                                               -1.0 / 1209600.0,
                                               1.0 / 47900160.0,
                                               -691.0 / 1307674368000.0};

// Largest step of the log scale, a factor of 20: Ceres measures a gradient by stepping along all of
// it, which is thousands on long loops, and gives up when that overflows.
constexpr double kMaxLogScaleStep = 3.0;

/// ad(x) y is the Lie bracket of x and y: the derivative of adjoint(exp(x)).
Mat7d bracket(const Vec7d& x) {
  Mat7d ad = Mat7d::Zero();
  const Mat3d W = skew(x.segment<3>(3));
  ad.topLeftCorner<3, 3>() = W + x(6) * Mat3d::Identity();
  ad.block<3, 3>(0, 3) = skew(x.head<3>());
  ad.block<3, 1>(0, 6) = -x.head<3>();
  ad.block<3, 3>(3, 3) = W;
  return ad;
}

void writeJacobian(const Mat7d& J, double* block) {
  if (block == nullptr) return;  // Ceres asks for no derivative by a fixed camera.
  Eigen::Map<RowMat78d> J_ambient(block);
  J_ambient.leftCols<kSimilarityTangent>() = J;
  J_ambient.col(kSimilarityTangent).setZero();
}

}  // namespace

Vec8d toSimilarityBlock(const Sim3d& S_cam_world) {
  Vec8d block;
  block << S_cam_world.q.coeffs(), S_cam_world.t, std::log(S_cam_world.s);
  return block;
}

Sim3d fromSimilarityBlock(const double* block) {
  Sim3d S_cam_world;
  S_cam_world.q = Eigen::Map<const Eigen::Quaterniond>(block);
  S_cam_world.t = Eigen::Map<const Vec3d>(block + 4);
  S_cam_world.s = std::exp(block[7]);
  return S_cam_world;
}

Mat7d adjoint(const Sim3d& S_a_b) {
  const Mat3d R = S_a_b.q.toRotationMatrix();
  Mat7d Ad = Mat7d::Identity();
  Ad.topLeftCorner<3, 3>() = S_a_b.s * R;
  Ad.block<3, 3>(0, 3) = skew(S_a_b.t) * R;
  Ad.block<3, 1>(0, 6) = -S_a_b.t;
  Ad.block<3, 3>(3, 3) = R;
  return Ad;
}

Mat7d leftJacobianInverse(const Vec7d& x) {
  const Mat7d ad = bracket(x);
  const Mat7d ad2 = ad * ad;
  Mat7d sum = Mat7d::Zero();  // Horner's rule in ad^2
  for (std::size_t i = kEvenBernoulli.size(); i-- > 0;) {
    sum.diagonal().array() += kEvenBernoulli[i];
    sum = ad2 * sum;
  }
  return Mat7d::Identity() - 0.5 * ad + sum;
}

bool LeftSimilarityManifold::Plus(const double* x,
                                  const double* delta,
                                  double* x_plus_delta) const {
  Vec7d step = Eigen::Map<const Vec7d>(delta);
  if (!step.allFinite()) return false;
  step(6) = std::clamp(step(6), -kMaxLogScaleStep, kMaxLogScaleStep);
  const Sim3d moved = Sim3d::exp(step) * fromSimilarityBlock(x);
  Eigen::Map<Vec8d> block(x_plus_delta);
  block = toSimilarityBlock(moved);
  return block.allFinite();
}

bool LeftSimilarityManifold::PlusJacobian(const double*, double* jacobian) const {
  Eigen::Map<RowMat87d>(jacobian).setIdentity();
  return true;
}

bool LeftSimilarityManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vec7d> delta(y_minus_x);
  delta = (fromSimilarityBlock(y) * fromSimilarityBlock(x).inverse()).log();
  return delta.allFinite();
}

bool LeftSimilarityManifold::MinusJacobian(const double*, double* jacobian) const {
  Eigen::Map<RowMat78d>(jacobian).setIdentity();
  return true;
}

SimilarityCost::SimilarityCost(const Sim3d& S_a_b, double weight)
    : S_a_b_(S_a_b), sqrt_weight_(std::sqrt(weight)) {}

bool SimilarityCost::Evaluate(const double* const* parameters,
                              double* residual,
                              double** jacobians) const {
  const Sim3d S_a_world = fromSimilarityBlock(parameters[0]);
  const Sim3d S_b_world = fromSimilarityBlock(parameters[1]);
  const Vec7d error = (S_a_b_ * S_b_world * S_a_world.inverse()).log();
  Eigen::Map<Vec7d>(residual, kSimilarityTangent) = sqrt_weight_ * error;
  if (jacobians == nullptr) return error.allFinite();
  writeJacobian(-sqrt_weight_ * leftJacobianInverse(-error), jacobians[0]);
  writeJacobian(sqrt_weight_ * leftJacobianInverse(error) * adjoint(S_a_b_), jacobians[1]);
  return error.allFinite();
}

}  // namespace glide
