#pragma once

#include "base/cancel.h"

#include <ceres/ceres.h>

#include <atomic>

namespace glide {

/// Who factorises sparse systems. Not SuiteSparse, Ceres' default: it runs OpenMP threads of its
/// own behind our back, its supernodal part is under the GPL, and phones do not have it.
inline constexpr ceres::SparseLinearAlgebraLibraryType kSparseLibrary = ceres::EIGEN_SPARSE;

/// Costs, losses and manifolds belong to whoever made the problem.
inline ceres::Problem::Options borrowingEverything() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

/// Ends a solve when the flag is set: SOLVER_TERMINATE_SUCCESSFULLY keeps the best state so far,
/// SOLVER_ABORT makes the solution not usable.
class CancelCallback final : public ceres::IterationCallback {
 public:
  CancelCallback(const std::atomic<bool>* cancel, ceres::CallbackReturnType when_cancelled)
      : cancel_(cancel), when_cancelled_(when_cancelled) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return isCancelled(cancel_) ? when_cancelled_ : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::atomic<bool>* cancel_;
  ceres::CallbackReturnType when_cancelled_;
};

}  // namespace glide
