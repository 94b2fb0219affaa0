#pragma once

#include "optimize/bundle_problem.h"
#include "optimize/residuals.h"

#include "geometry/camera_model.h"
#include "geometry/eigen_types.h"

#include <atomic>
#include <vector>

namespace glide {

/// The free numbers of a bundle in the layout that Ceres changes in place.
struct BundleState {
  std::vector<Vec7d> poses;  ///< toPoseBlock(T_cam_world)
  std::vector<Vec3d> points;
};

/// What a round solves: cameras and observations of `bundle`, those of them that `use` chooses (at
/// least one). Poses and points are taken from the state.
struct RoundInput {
  const CameraModel& camera;
  const BundleProblem& bundle;
  const std::vector<bool>& use;  ///< per observation
};

struct RoundOptions {
  Loss loss = Loss::huber;
  int max_iterations = 10;
  double trust_region_radius = 0.0;  ///< to start from
  const std::atomic<bool>* cancel = nullptr;
};

struct RoundResult {
  bool usable = false;     ///< false: the state may hold anything
  bool cancelled = false;  ///< the state is the best one so far
  int iterations = 0;
  double trust_region_radius = 0.0;  ///< at the end
};

/// One Levenberg-Marquardt solve with Ceres. May throw std::bad_alloc.
RoundResult solveRound(const RoundInput& input, const RoundOptions& options, BundleState* state);

}  // namespace glide
