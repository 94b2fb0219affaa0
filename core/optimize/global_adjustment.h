#pragma once

#include "map/map_snapshot.h"
#include "map/messages.h"

#include "geometry/camera_model.h"

#include <atomic>
#include <optional>

namespace glide {

struct GlobalAdjustmentOptions {
  ScaleLevels levels;
  int max_iterations = 10;
  const std::atomic<bool>* cancel = nullptr;  ///< may be null; checked once per iteration
};

/// Bundle adjustment of all keyframes and landmarks of a snapshot; the oldest keyframe stays where
/// it is, and so does the overall scale. Nothing when cancelled, when there is too little to
/// adjust, or when the solve fails.
std::optional<GlobalAdjustment> adjustGlobally(const CameraModel& camera,
                                               const MapSnapshot& map,
                                               const GlobalAdjustmentOptions& options);

}  // namespace glide
