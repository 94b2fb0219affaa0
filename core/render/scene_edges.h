#pragma once

#include "render/scene_records.h"

#include "glide/map_view.h"

#include <vector>

namespace glide {

/// Lines between each keyframe and those that it shares most landmarks with, at most `neighbors` of
/// them; each pair once. Two records a line.
std::vector<PointRecord> covisibilityEdges(const MapView& map, int neighbors);

/// Lines between the two keyframes of each loop. Two records a line.
std::vector<PointRecord> loopEdges(const MapView& map);

}  // namespace glide
