#pragma once

#include "loop/loop_verifier.h"

#include "map/landmark.h"
#include "map/map_snapshot.h"
#include "map/messages.h"

#include "geometry/camera_model.h"

#include <vector>

namespace glide {

/// Landmarks of the newer side of a loop that are landmarks of the older side, ascending by `gone`:
/// those of the older side are looked for by the newer keyframe and its covisible ones, and the
/// other way round. Several may go into one, none that an image shows apart.
std::vector<LoopCorrection::SamePoint> findSamePoints(const CameraModel& camera,
                                                      const ScaleLevels& levels,
                                                      const LoopGeometry& loop,
                                                      const MapSnapshot& map);

}  // namespace glide
