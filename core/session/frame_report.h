#pragma once

#include "track/anchored_pose.h"

#include "geometry/pose_conversion.h"

#include "glide/frame.h"

#include <optional>

namespace glide {

/// Fills in the pose of a result: in the world of `map`, and relative to its keyframe.
void describePose(const AnchoredPose& pose, const MapSnapshot& map, FrameResult* result);

/// Adds what earlier attempts at the same frame cost.
void addTimes(const FrameStats& earlier, FrameStats* stats);

/// How far corrections between two snapshots of a map have moved a camera; nothing when there were
/// none.
std::optional<WorldCorrection> correctionBetween(const MapSnapshot& before,
                                                 const MapSnapshot& after,
                                                 const AnchoredPose& pose);

}  // namespace glide
