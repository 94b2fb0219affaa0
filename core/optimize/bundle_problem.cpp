#include "optimize/bundle_problem.h"

#include "optimize/bundle_round.h"
#include "optimize/reprojection_cost.h"
#include "optimize/residuals.h"

#include "base/cancel.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

namespace glide {
namespace {

// A point seen less often has a direction in which nothing holds it.
constexpr int kMinViewsOfPoint = 2;

BundleState stateOf(const BundleProblem& problem) {
  BundleState state;
  state.poses.reserve(problem.cameras.size());
  for (const BundleProblem::Camera& camera : problem.cameras) {
    state.poses.push_back(toPoseBlock(camera.T_cam_world));
  }
  state.points = problem.points;
  return state;
}

/// Squared norm of every observation's residual, in sigma^2; infinity where the point does not
/// project.
std::vector<double> chi2OfAll(const CameraModel& camera,
                              const BundleProblem& problem,
                              const BundleState& state) {
  std::vector<Mat3d> R_cam_world;
  R_cam_world.reserve(state.poses.size());
  for (const Vec7d& pose : state.poses) {
    R_cam_world.push_back(fromPoseBlock(pose.data()).rotation());
  }
  std::vector<double> chi2;
  chi2.reserve(problem.observations.size());
  for (const BundleObservation& o : problem.observations) {
    const std::size_t c = std::size_t(o.camera);
    const Vec3d p_cam =
        R_cam_world[c] * state.points[std::size_t(o.point)] + state.poses[c].tail<3>();
    const auto r = reprojectionResidual(camera, p_cam, o.uv, o.inv_sigma);
    chi2.push_back(r ? r->squaredNorm() : std::numeric_limits<double>::infinity());
  }
  return chi2;
}

/// Robust cost of all observations, used or not, so that it can be compared before and after.
double robustCost(const std::vector<double>& chi2) {
  double sum = 0.0;
  for (const double value : chi2) {
    const double norm = std::isfinite(value) ? std::sqrt(value) : kUnprojectableNorm;
    sum += huberCost(norm, kReprojectionHuber);
  }
  return sum;
}

std::vector<bool> insideGate(const std::vector<double>& chi2) {
  std::vector<bool> inside(chi2.size());
  for (std::size_t i = 0; i < chi2.size(); ++i) inside[i] = chi2[i] < kChi2_2;
  return inside;
}

/// The first round trusts the caller's flags, not the gate: the start may be far from the optimum.
std::vector<bool> flaggedAndProjected(const BundleProblem& problem,
                                      const std::vector<double>& chi2) {
  std::vector<bool> use(chi2.size());
  for (std::size_t i = 0; i < chi2.size(); ++i) {
    use[i] = problem.observations[i].inlier && std::isfinite(chi2[i]);
  }
  return use;
}

std::vector<int> viewsPerPoint(const BundleProblem& problem, const std::vector<bool>& use) {
  std::vector<int> views(problem.points.size(), 0);
  for (std::size_t i = 0; i < use.size(); ++i) {
    if (use[i]) ++views[std::size_t(problem.observations[i].point)];
  }
  return views;
}

/// Takes out the observations of points that too few others see; returns how many remain.
int dropLoosePoints(const BundleProblem& problem, std::vector<bool>* use) {
  const std::vector<int> views = viewsPerPoint(problem, *use);
  int remaining = 0;
  for (std::size_t i = 0; i < use->size(); ++i) {
    if (views[std::size_t(problem.observations[i].point)] < kMinViewsOfPoint) (*use)[i] = false;
    remaining += (*use)[i] ? 1 : 0;
  }
  return remaining;
}

/// Points that too few inliers see stay where they were before the solve.
void restoreLoosePoints(const BundleProblem& problem,
                        const std::vector<bool>& inside,
                        BundleState* state) {
  const std::vector<int> views = viewsPerPoint(problem, inside);
  for (std::size_t p = 0; p < views.size(); ++p) {
    if (views[p] < kMinViewsOfPoint) state->points[p] = problem.points[p];
  }
}

/// What the rounds change.
struct Iterate {
  BundleState state;
  std::vector<bool> use;  ///< per observation: takes part in the next round
};

/// Solve, then decide anew about every observation, and again.
BundleSummary runRounds(const CameraModel& camera,
                        const BundleProblem& problem,
                        const BundleOptions& options,
                        Iterate* iterate) {
  BundleSummary summary;
  RoundOptions round_options;
  round_options.max_iterations = options.max_iterations;
  round_options.trust_region_radius = options.trust_region_radius;
  round_options.cancel = options.cancel;
  for (int round = 0; round < options.rounds && !summary.cancelled; ++round) {
    summary.usable = dropLoosePoints(problem, &iterate->use) > 0;
    if (!summary.usable) break;
    round_options.loss = round + 1 < options.rounds ? Loss::huber : Loss::squared;
    const RoundResult result =
        solveRound({camera, problem, iterate->use}, round_options, &iterate->state);
    summary.usable = result.usable;
    if (!summary.usable) break;
    summary.cancelled = result.cancelled || isCancelled(options.cancel);
    summary.iterations += result.iterations;
    round_options.trust_region_radius = result.trust_region_radius;
    iterate->use = insideGate(chi2OfAll(camera, problem, iterate->state));
  }
  return summary;
}

void writeBack(const BundleState& state, const std::vector<bool>& inside, BundleProblem* problem) {
  for (std::size_t c = 0; c < problem->cameras.size(); ++c) {
    BundleProblem::Camera& camera = problem->cameras[c];
    if (!camera.fixed) camera.T_cam_world = fromPoseBlock(state.poses[c].data());
  }
  problem->points = state.points;
  for (std::size_t i = 0; i < inside.size(); ++i) problem->observations[i].inlier = inside[i];
}

BundleSummary solve(const CameraModel& camera,
                    const BundleOptions& options,
                    BundleProblem* problem) {
  Iterate iterate{stateOf(*problem), {}};
  const std::vector<double> chi2_before = chi2OfAll(camera, *problem, iterate.state);
  iterate.use = flaggedAndProjected(*problem, chi2_before);
  BundleSummary summary = runRounds(camera, *problem, options, &iterate);
  if (!summary.usable) return BundleSummary{};

  restoreLoosePoints(*problem, iterate.use, &iterate.state);
  const std::vector<double> chi2_after = chi2OfAll(camera, *problem, iterate.state);
  const std::vector<bool> inside = insideGate(chi2_after);
  summary.initial_cost = robustCost(chi2_before);
  summary.final_cost = robustCost(chi2_after);
  summary.outliers = static_cast<int>(std::count(inside.begin(), inside.end(), false));
  writeBack(iterate.state, inside, problem);
  return summary;
}

}  // namespace

BundleSummary solveBundle(const CameraModel& camera,
                          const BundleOptions& options,
                          BundleProblem* problem) {
  if (isCancelled(options.cancel)) {
    BundleSummary summary;
    summary.cancelled = true;
    return summary;
  }
  try {
    return solve(camera, options, problem);
  } catch (const std::exception&) {
    return BundleSummary{};  // Ceres or the allocator gave up; the problem is written at the end
                             // only.
  }
}

}  // namespace glide
