#include "optimize/bundle_round.h"

#include "optimize/ceres_setup.h"
#include "optimize/reprojection_cost.h"

#include <deque>
#include <memory>

namespace glide {
namespace {

// Below this many free cameras the reduced camera system is solved densely
// (docs/decisions/0002-bundle-solver.md).
constexpr int kMaxDenseCameras = 80;

// The order of elimination: the points, whose part of the system is block-diagonal, go first.
constexpr int kPointGroup = 0;
constexpr int kCameraGroup = 1;

// Relative decrease of the cost at which a round ends. Huber's cost is mostly the outliers', which
// creep along and leave with the gate anyway, so those rounds end sooner. This test alone decides:
// Ceres' test on the length of the step would depend on the map's scale and on the number of
// points.
constexpr double kHuberTolerance = 1e-4;
constexpr double kSquaredTolerance = 1e-6;
constexpr double kParameterTolerance = 0.0;

/// A ceres::Problem and what it points to.
struct RoundProblem {
  std::deque<ReprojectionCost> costs;  // neither copied nor moved

  ceres::HuberLoss huber{kReprojectionHuber};
  LeftPoseManifold manifold;
  ceres::Problem problem{borrowingEverything()};
  std::shared_ptr<ceres::ParameterBlockOrdering> ordering =
      std::make_shared<ceres::ParameterBlockOrdering>();
  int free_cameras = 0;
};

void addObservations(const RoundInput& input, Loss loss, BundleState* state, RoundProblem* round) {
  ceres::LossFunction* loss_function = loss == Loss::huber ? &round->huber : nullptr;
  for (std::size_t i = 0; i < input.bundle.observations.size(); ++i) {
    if (!input.use[i]) continue;
    const BundleObservation& o = input.bundle.observations[i];
    round->costs.emplace_back(input.camera, o.uv, o.inv_sigma);
    double* pose = state->poses[std::size_t(o.camera)].data();
    double* point = state->points[std::size_t(o.point)].data();
    round->problem.AddResidualBlock(&round->costs.back(), loss_function, pose, point);
    round->ordering->AddElementToGroup(point, kPointGroup);
  }
}

void addCameras(const BundleProblem& bundle, BundleState* state, RoundProblem* round) {
  for (std::size_t c = 0; c < bundle.cameras.size(); ++c) {
    double* pose = state->poses[c].data();
    if (!round->problem.HasParameterBlock(pose)) continue;
    round->ordering->AddElementToGroup(pose, kCameraGroup);
    if (bundle.cameras[c].fixed) {
      round->problem.SetParameterBlockConstant(pose);
    } else {
      round->problem.SetManifold(pose, &round->manifold);
      ++round->free_cameras;
    }
  }
}

ceres::Solver::Options solverOptions(const RoundOptions& options, const RoundProblem& round) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type =
      round.free_cameras <= kMaxDenseCameras ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
  ceres_options.linear_solver_ordering = round.ordering;
  ceres_options.sparse_linear_algebra_library_type = kSparseLibrary;
  ceres_options.initial_trust_region_radius = options.trust_region_radius;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.function_tolerance =
      options.loss == Loss::huber ? kHuberTolerance : kSquaredTolerance;
  ceres_options.parameter_tolerance = kParameterTolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  return ceres_options;
}

}  // namespace

RoundResult solveRound(const RoundInput& input, const RoundOptions& options, BundleState* state) {
  RoundProblem round;
  addObservations(input, options.loss, state, &round);
  addCameras(input.bundle, state, &round);

  ceres::Solver::Options ceres_options = solverOptions(options, round);
  CancelCallback callback(options.cancel, ceres::SOLVER_TERMINATE_SUCCESSFULLY);
  ceres_options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &round.problem, &summary);

  RoundResult result;
  result.usable = summary.IsSolutionUsable();
  result.cancelled = summary.termination_type == ceres::USER_SUCCESS;
  if (!summary.iterations.empty()) {
    result.iterations = summary.iterations.back().iteration;
    result.trust_region_radius = summary.iterations.back().trust_region_radius;
  }
  return result;
}

}  // namespace glide
