#pragma once

#include "replay/outputs/run_record.h"
#include "replay/outputs/run_trajectories.h"

#include <nlohmann/json.hpp>

namespace glide::replay {

/// frames.csv for the report: one column per key, each the base64 of an array of numbers.
/// `state`, `tracker` and `reason` are indices into `names`; `placed` is 1 for the frames that have
/// a pose in the trajectory.
nlohmann::ordered_json reportFrames(const RunRecord& run, const RunTrajectories& trajectories);

}  // namespace glide::replay
