#pragma once

#include "mapping/mapper_state.h"

#include "optimize/bundle_problem.h"

#include <vector>

namespace glide {

/// What one bundle adjustment touches; each list ascending.
struct AdjustmentWindow {
  std::vector<KeyframeId> moving;     ///< poses are optimised
  std::vector<KeyframeId> fixed;      ///< see the landmarks, poses stay
  std::vector<LandmarkId> landmarks;  ///< all that a moving keyframe sees
};

/// `id` with its best covisible keyframes, at most `max_keyframes`; the whole map when it is not
/// larger. The map's first keyframe never moves.
AdjustmentWindow windowAround(const Map& map, KeyframeId id, int max_keyframes);

/// The window as the solver takes it: cameras in the order moving, fixed; points as its landmarks.
BundleProblem bundleOf(const Map& map, const AdjustmentWindow& window);

/// Bundle adjustment of the window; afterwards outlier observations are removed (with landmarks
/// that keep fewer than two) and landmark geometry is refreshed. When fewer than two keyframes are
/// fixed the scale is free: it is restored so that the cameras' mean distance from the fixed one
/// stays.
BundleSummary adjustWindow(MapperState* state,
                           const AdjustmentWindow& window,
                           const BundleOptions& options);

}  // namespace glide
