#include "optimize/pose_optimizer.h"

#include "optimize/residuals.h"

#include "geometry/robust.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace glide {
namespace {

constexpr int kRounds = 4;
constexpr int kLastRound = kRounds - 1;  // without Huber
constexpr int kMaxIterations = 10;  // per round; two or three are common, a bad guess takes more
constexpr int kMinInliers = 6;      // twice the three points that a pose needs

// Damping relative to the diagonal: so small that the step is Gauss-Newton's until one fails.
constexpr double kInitialDamping = 1e-6;
constexpr double kDampingUp = 100.0;
constexpr double kDampingDown = 0.1;

// Predicted decrease of the cost, in sigma^2: a step of a thousandth of the pose's standard
// deviation.
constexpr double kConverged = 1e-6;

// Smallest pivot of the system scaled to a unit diagonal; below it a direction is not observed.
constexpr double kMinPivot = 1e-10;

struct PoseProblem {
  const CameraModel& camera;
  std::span<const PoseObservation> observations;
};

struct NormalEquations {
  Mat6d H = Mat6d::Zero();  // J^T W J
  Vec6d g = Vec6d::Zero();  // J^T W r
  double cost = 0.0;
};

NormalEquations linearize(const PoseProblem& problem,
                          const std::vector<bool>& use,
                          Loss loss,
                          const SE3d& T_cam_world) {
  const double threshold = loss == Loss::huber ? kReprojectionHuber : INFINITY;
  const Mat3d R_cam_world = T_cam_world.rotation();
  NormalEquations sum;
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    if (!use[i]) continue;
    const PoseObservation& o = problem.observations[i];
    const Vec3d p_cam = R_cam_world * o.p_world + T_cam_world.t;
    const auto lin = linearizeReprojection(problem.camera, p_cam, o.uv, o.inv_sigma);
    if (!lin) {
      sum.cost += huberCost(kUnprojectableNorm, threshold);
      continue;
    }
    const double norm = lin->r.norm();
    const double weight = huberWeight(norm, threshold);
    // Transposed, so that the columns of the products are contiguous and the loops vectorise.
    const Eigen::Matrix<double, 6, 2> Jt = leftPoseJacobian(lin->J_r_point, p_cam).transpose();
    const Eigen::Matrix<double, 6, 2> weighted = weight * Jt;
    sum.H.noalias() += weighted.lazyProduct(Jt.transpose());
    sum.g.noalias() += weighted.lazyProduct(lin->r);
    sum.cost += huberCost(norm, threshold);
  }
  return sum;
}

Vec6d dampedStep(const NormalEquations& system, double damping) {
  Mat6d H = system.H;
  H.diagonal() *= 1.0 + damping;
  return -H.ldlt().solve(system.g);
}

SE3d minimize(const PoseProblem& problem,
              const std::vector<bool>& use,
              Loss loss,
              const SE3d& T_cam_world_guess) {
  SE3d T_cam_world = T_cam_world_guess;
  NormalEquations system = linearize(problem, use, loss, T_cam_world);
  double damping = kInitialDamping;
  for (int k = 0; k < kMaxIterations; ++k) {
    const Vec6d step = dampedStep(system, damping);
    if (!step.allFinite()) break;
    if (-step.dot(system.g) < kConverged) return SE3d::exp(step) * T_cam_world;
    const SE3d T_trial = SE3d::exp(step) * T_cam_world;
    const NormalEquations trial = linearize(problem, use, loss, T_trial);
    if (trial.cost < system.cost) {
      T_cam_world = T_trial;
      system = trial;
      damping *= kDampingDown;
    } else {
      damping *= kDampingUp;
    }
  }
  return T_cam_world;
}

/// Decides anew for every observation; sets inlier, inliers and rms_px of the estimate. Tells
/// whether a decision differs from the last one.
bool gate(const PoseProblem& problem, PoseEstimate* estimate) {
  const Mat3d R_cam_world = estimate->T_cam_world.rotation();
  double sum_chi2 = 0.0;
  bool changed = false;
  estimate->inliers = 0;
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    const PoseObservation& o = problem.observations[i];
    const Vec3d p_cam = R_cam_world * o.p_world + estimate->T_cam_world.t;
    const auto r = reprojectionResidual(problem.camera, p_cam, o.uv, o.inv_sigma);
    const bool inside = r && r->squaredNorm() < kChi2_2;
    changed = changed || estimate->inlier[i] != inside;
    estimate->inlier[i] = inside;
    if (!inside) continue;
    ++estimate->inliers;
    sum_chi2 += r->squaredNorm();
  }
  estimate->rms_px = estimate->inliers > 0 ? std::sqrt(sum_chi2 / estimate->inliers) : 0.0;
  return changed;
}

/// All six directions are held by the observations.
bool isWellPosed(const Mat6d& H) {
  if (!H.allFinite() || !(H.diagonal().minCoeff() > 0.0)) return false;
  const Vec6d scale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Mat6d unit = scale.asDiagonal() * H * scale.asDiagonal();
  return unit.ldlt().vectorD().minCoeff() > kMinPivot;
}

}  // namespace

PoseEstimate optimizePose(const CameraModel& camera,
                          const SE3d& T_cam_world_guess,
                          std::span<const PoseObservation> observations) {
  const PoseProblem problem{camera, observations};
  PoseEstimate estimate;
  estimate.T_cam_world = T_cam_world_guess;
  estimate.inlier.assign(observations.size(), true);
  estimate.inliers = static_cast<int>(observations.size());
  for (int round = 0; round < kRounds && estimate.inliers >= kMinInliers;) {
    const Loss loss = round < kLastRound ? Loss::huber : Loss::squared;
    estimate.T_cam_world = minimize(problem, estimate.inlier, loss, estimate.T_cam_world);
    const bool changed = gate(problem, &estimate);
    // A further round with Huber would find the same optimum of the same observations.
    round = changed || round == kLastRound ? round + 1 : kLastRound;
  }
  if (estimate.inliers < kMinInliers) return estimate;
  estimate.H = linearize(problem, estimate.inlier, Loss::squared, estimate.T_cam_world).H;
  estimate.valid = isWellPosed(estimate.H);
  return estimate;
}

}  // namespace glide
