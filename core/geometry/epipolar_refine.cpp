#include "geometry/epipolar_refine.h"

#include "geometry/essential.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace glide {
namespace {

using Vec5d = Eigen::Matrix<double, 5, 1>;
using Mat5d = Eigen::Matrix<double, 5, 5>;

/// Derivatives of E by the five parameters.
using EssentialDerivatives = std::array<Mat3d, 5>;

/// Tukey's constant: 95 % efficiency on Gaussian noise.
constexpr double kTukey = 4.685;

/// Scale of the weight in the first iterations, in sigmas: a sample of five pairs is that far off.
constexpr std::array<double, 4> kScales{4.0, 2.0, 1.5, 1.0};
constexpr int kMaxIterations = 20;
constexpr double kConverged = 1e-9;  // radians

/// Largest leverage, in means over all pairs (five parameters / number of pairs).
constexpr double kMaxLeverage = 3.0;

/// Added to the diagonal, relative: keeps the solve defined where a direction is free.
constexpr double kDamping = 1e-9;

/// E of a pose, its derivatives and whatever else all pairs share.
struct Linearisation {
  Mat3d E;
  EssentialDerivatives dE;
};

Linearisation linearise(const SE3d& T_b_a) {
  const Mat3d R = T_b_a.rotation();
  const Mat32d basis = tangentBasis(T_b_a.t);
  Linearisation at;
  at.E = skew(T_b_a.t) * R;
  for (int axis = 0; axis < 3; ++axis) {
    at.dE[static_cast<std::size_t>(axis)] = skew(T_b_a.t) * skew(Vec3d::Unit(axis)) * R;
  }
  for (int axis = 0; axis < 2; ++axis) {
    at.dE[static_cast<std::size_t>(3 + axis)] = skew(basis.col(axis)) * R;
  }
  return at;
}

SampsonResidual residualOf(const Linearisation& at, const RayPair& pair) {
  const double algebraic = pair.b.f.dot(at.E * pair.a.f);
  const Vec2d slope_b = pair.b.J_bearing_uv.transpose() * (at.E * pair.a.f);
  const Vec2d slope_a = pair.a.J_bearing_uv.transpose() * (at.E.transpose() * pair.b.f);
  const double slope2 = slope_a.squaredNorm() + slope_b.squaredNorm();
  const double inverse_slope = 1.0 / std::sqrt(slope2);

  SampsonResidual out;
  out.error = algebraic * inverse_slope;
  // The quotient rule, gathered by what stands left and right of dE.
  const double share = algebraic / slope2;
  const Vec3d left = (pair.b.f - share * (pair.b.J_bearing_uv * slope_b)) * inverse_slope;
  const Vec3d right = pair.a.J_bearing_uv * slope_a * (share * inverse_slope);
  for (int i = 0; i < 5; ++i) {
    const Mat3d& dE = at.dE[static_cast<std::size_t>(i)];
    out.J_error_pose(i) = left.dot(dE * pair.a.f) - pair.b.f.dot(dE * right);
  }
  return out;
}

struct NormalEquations {
  Mat5d H = Mat5d::Zero();
  Vec5d b = Vec5d::Zero();
  double weight = 0.0;  ///< sum of the weights
};

/// Bound of a pair's influence: its leverage J H^-1 J^T beyond the limit is paid for by its weight.
/// Wrong pairs have a wild parallax, so that their leverage is many times that of right ones; those
/// few that fit by chance would otherwise pull the translation towards themselves.
struct LeverageBound {
  Mat5d H_inverse = Mat5d::Zero();
  double limit = 1.0;

  double weight(const Eigen::Matrix<double, 1, 5>& J) const {
    const double leverage = (J * H_inverse * J.transpose()).value();
    return leverage > limit ? limit / leverage : 1.0;
  }
};

NormalEquations accumulate(const SE3d& T_b_a,
                           std::span<const RayPair> pairs,
                           double cutoff,
                           const LeverageBound& bound) {
  const Linearisation at = linearise(T_b_a);
  NormalEquations sums;
  for (const RayPair& pair : pairs) {
    const SampsonResidual residual = residualOf(at, pair);
    const double ratio = residual.error / cutoff;
    if (!(std::abs(ratio) < 1.0)) continue;
    const Eigen::Matrix<double, 1, 5>& J = residual.J_error_pose;
    const double weight = (1.0 - ratio * ratio) * (1.0 - ratio * ratio) * bound.weight(J);
    sums.H.noalias() += weight * J.transpose() * J;
    sums.b.noalias() -= weight * residual.error * J.transpose();
    sums.weight += weight;
  }
  sums.H.diagonal() *= 1.0 + kDamping;
  return sums;
}

SE3d moved(const SE3d& T_b_a, const Vec5d& step) {
  const Vec3d t = T_b_a.t + tangentBasis(T_b_a.t) * step.tail<2>();
  return SE3d{(so3Exp(step.head<3>()) * T_b_a.q).normalized(), t.normalized()};
}

/// Standard deviation of the worst direction of t, from the inverse of the normal equations.
double directionStd(const Mat5d& H, double sigma_px) {
  const Mat2d covariance = H.inverse().bottomRightCorner<2, 2>() * (sigma_px * sigma_px);
  if (!covariance.allFinite()) return std::numeric_limits<double>::infinity();
  const Eigen::SelfAdjointEigenSolver<Mat2d> solver(covariance);
  return std::sqrt(solver.eigenvalues()(1));
}

}  // namespace

Mat32d tangentBasis(const Vec3d& direction) {
  Mat32d basis;
  basis.col(0) = direction.unitOrthogonal();
  basis.col(1) = direction.cross(basis.col(0));
  return basis;
}

SampsonResidual sampsonResidual(const SE3d& T_b_a, const RayPair& pair) {
  return residualOf(linearise(T_b_a), pair);
}

RefinedPose refineEpipolar(const SE3d& T_b_a, std::span<const RayPair> pairs, double sigma_px) {
  SE3d T = T_b_a;
  NormalEquations sums;
  LeverageBound bound;
  for (std::size_t i = 0; i < kMaxIterations; ++i) {
    const double scale = kScales[std::min(i, kScales.size() - 1)];
    sums = accumulate(T, pairs, kTukey * sigma_px * scale, bound);
    const Vec5d step = sums.H.ldlt().solve(sums.b);
    if (!step.allFinite()) break;
    T = moved(T, step);
    bound = {sums.H.inverse(), kMaxLeverage * 5.0 / sums.weight};
    if (i >= kScales.size() && step.norm() < kConverged) break;
  }
  return {T, directionStd(sums.H, sigma_px)};
}

}  // namespace glide
