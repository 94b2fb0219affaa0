#pragma once

#include "replay/evaluation/evaluate.h"
#include "replay/outputs/run_record.h"

#include "geometry/lie.h"

#include <vector>

namespace glide::replay {

/// The camera's trajectories of a run. When the session started its map over, only the poses of the
/// last map are kept: the worlds of two maps have nothing to do with each other.
struct RunTrajectories {
  /// recomposed: every tracked frame, by the final pose of its reference keyframe; live: the same
  /// frames as the app saw them; keyframes: those that are in the map at the end.
  Estimates camera;
  std::vector<bool> kept;  ///< per RunRecord::frames: whether it is in camera.recomposed
  int of_older_maps = 0;   ///< tracked frames left out because their map was given up
};

RunTrajectories buildTrajectories(const RunRecord& run);

/// A pose of the public API as a transform.
SE3d toSE3(const Pose& pose);

}  // namespace glide::replay
