#include "optimize/sim3_optimizer.h"

#include "optimize/residuals.h"

#include "geometry/robust.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>

namespace glide {
namespace {

constexpr int kRounds = 3;
constexpr int kMaxIterations = 10;  // per round; two or three are common
constexpr int kMinInliers = 6;      // twice the three points that a similarity needs

// Damping relative to the diagonal: so small that the step is Gauss-Newton's until one fails.
constexpr double kInitialDamping = 1e-6;
constexpr double kDampingUp = 100.0;
constexpr double kDampingDown = 0.1;

// Predicted decrease of the cost, in sigma^2: a step of a thousandth of the standard deviation.
constexpr double kConverged = 1e-6;

// Smallest pivot of the system scaled to a unit diagonal; below it a direction is not observed.
constexpr double kMinPivot = 1e-10;

using Mat37d = Eigen::Matrix<double, 3, 7>;

struct Sim3Problem {
  const CameraModel& camera;
  std::span<const Sim3Pair> pairs;
  double huber;  // sigmas
};

struct NormalEquations {
  Mat7d H = Mat7d::Zero();  // J^T W J
  Vec7d g = Vec7d::Zero();  // J^T W r
  double cost = 0.0;
};

/// Derivative of exp(delta) * p by delta at zero: [ I | -[p]x | p ].
Mat37d leftSimilarityJacobian(const Vec3d& p) {
  Mat37d J;
  J << Mat3d::Identity(), -skew(p), p;
  return J;
}

template <int N>
void addError(const Eigen::Matrix<double, N, 1>& r,
              const Eigen::Matrix<double, N, 7>& J,
              double huber,
              NormalEquations* sum) {
  const double norm = r.norm();
  const double weight = huberWeight(norm, huber);
  sum->H.noalias() += weight * J.transpose() * J;
  sum->g.noalias() += weight * J.transpose() * r;
  sum->cost += huberCost(norm, huber);
}

NormalEquations linearize(const Sim3Problem& problem,
                          const std::vector<bool>& use,
                          const Sim3d& S_a_b) {
  NormalEquations sum;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    if (!use[i]) continue;
    const auto lin = linearizeSim3(problem.camera, S_a_b, problem.pairs[i]);
    if (!lin) {
      sum.cost += 3.0 * huberCost(kUnprojectableNorm, problem.huber);
      continue;
    }
    const Mat57d& J = lin->J_r_sim;
    addError<2>(lin->r.segment<2>(0), J.middleRows<2>(0), problem.huber, &sum);
    addError<2>(lin->r.segment<2>(2), J.middleRows<2>(2), problem.huber, &sum);
    addError<1>(lin->r.segment<1>(4), J.middleRows<1>(4), problem.huber, &sum);
  }
  return sum;
}

Vec7d dampedStep(const NormalEquations& system, double damping) {
  Mat7d H = system.H;
  H.diagonal() *= 1.0 + damping;
  return -H.ldlt().solve(system.g);
}

Sim3d minimize(const Sim3Problem& problem, const std::vector<bool>& use, const Sim3d& S_guess) {
  Sim3d S_a_b = S_guess;
  NormalEquations system = linearize(problem, use, S_a_b);
  double damping = kInitialDamping;
  for (int k = 0; k < kMaxIterations; ++k) {
    const Vec7d step = dampedStep(system, damping);
    if (!step.allFinite()) break;
    if (-step.dot(system.g) < kConverged) return Sim3d::exp(step) * S_a_b;
    const Sim3d S_trial = Sim3d::exp(step) * S_a_b;
    const NormalEquations trial = linearize(problem, use, S_trial);
    if (trial.cost < system.cost) {
      S_a_b = S_trial;
      system = trial;
      damping *= kDampingDown;
    } else {
      damping *= kDampingUp;
    }
  }
  return S_a_b;
}

/// Decides anew for every pair; sets inlier, inliers and rms_px of the estimate. Tells whether a
/// decision differs from the last one.
bool gate(const Sim3Problem& problem, double max_error2, Sim3Estimate* estimate) {
  double sum_chi2 = 0.0;
  bool changed = false;
  estimate->inliers = 0;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    const auto lin = linearizeSim3(problem.camera, estimate->S_a_b, problem.pairs[i]);
    const bool inside = lin && lin->r.segment<2>(0).squaredNorm() < max_error2 &&
                        lin->r.segment<2>(2).squaredNorm() < max_error2 &&
                        lin->r(4) * lin->r(4) < max_error2;
    changed = changed || estimate->inlier[i] != inside;
    estimate->inlier[i] = inside;
    if (!inside) continue;
    ++estimate->inliers;
    sum_chi2 += 0.5 * lin->r.head<4>().squaredNorm();
  }
  estimate->rms_px = estimate->inliers > 0 ? std::sqrt(sum_chi2 / estimate->inliers) : 0.0;
  return changed;
}

/// All seven directions are held by the pairs.
bool isWellPosed(const Mat7d& H) {
  if (!H.allFinite() || !(H.diagonal().minCoeff() > 0.0)) return false;
  const Vec7d scale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Mat7d unit = scale.asDiagonal() * H * scale.asDiagonal();
  return unit.ldlt().vectorD().minCoeff() > kMinPivot;
}

}  // namespace

std::optional<Sim3Residual> linearizeSim3(const CameraModel& camera,
                                          const Sim3d& S_a_b,
                                          const Sim3Pair& pair) {
  const Mat3d R_b_a_scaled = S_a_b.q.conjugate().toRotationMatrix() / S_a_b.s;
  const Vec3d p_in_a = S_a_b * pair.p_b;
  const Vec3d p_in_b = R_b_a_scaled * (pair.p_a - S_a_b.t);
  const auto in_a = linearizeReprojection(camera, p_in_a, pair.uv_a, pair.inv_sigma_a);
  const auto in_b = linearizeReprojection(camera, p_in_b, pair.uv_b, pair.inv_sigma_b);
  if (!in_a || !in_b) return std::nullopt;
  Sim3Residual out;
  const double depth_error = 0.5 * std::log(p_in_a.squaredNorm() / pair.p_a.squaredNorm());
  out.r << in_a->r, in_b->r, depth_error / kLogDepthSigma;
  // (exp(delta) S)^-1 p_a = S^-1 exp(-delta) p_a: the minus, and the linear part of S^-1.
  out.J_r_sim << in_a->J_r_point * leftSimilarityJacobian(p_in_a),
      -in_b->J_r_point * R_b_a_scaled * leftSimilarityJacobian(pair.p_a),
      // log|p| changes along p only: by the translation, and by the log scale itself.
      p_in_a.transpose() / (p_in_a.squaredNorm() * kLogDepthSigma), Vec3d::Zero().transpose(),
      1.0 / kLogDepthSigma;
  return out;
}

Sim3Estimate optimizeSim3(const CameraModel& camera,
                          std::span<const Sim3Pair> pairs,
                          const Sim3d& S_a_b_guess,
                          double max_error2) {
  const Sim3Problem problem{camera, pairs, std::sqrt(max_error2)};
  Sim3Estimate estimate;
  estimate.S_a_b = S_a_b_guess;
  estimate.inlier.assign(pairs.size(), true);
  estimate.inliers = static_cast<int>(pairs.size());
  for (int round = 0; round < kRounds && estimate.inliers >= kMinInliers; ++round) {
    estimate.S_a_b = minimize(problem, estimate.inlier, estimate.S_a_b);
    if (!gate(problem, max_error2, &estimate)) break;
  }
  if (estimate.inliers < kMinInliers) return estimate;
  estimate.valid = isWellPosed(linearize(problem, estimate.inlier, estimate.S_a_b).H);
  return estimate;
}

}  // namespace glide
