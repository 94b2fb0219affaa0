#pragma once

#include "replay/outputs/point_colors.h"
#include "replay/outputs/run_record.h"
#include "replay/outputs/run_trajectories.h"

#include <string>

namespace glide::replay {

/// map.glb: the final map for every viewer of glTF 2.0. Landmarks as coloured points, the camera's
/// trajectory as line strips in the colours of the trackers (one strip per stretch of tracked
/// frames), the map's keyframes as frusta. The root node turns the map's world (y down, z forward)
/// to glTF's axes (y up).
std::string mapGlb(const RunRecord& run,
                   const RunTrajectories& trajectories,
                   const PointColors& colors);

}  // namespace glide::replay
