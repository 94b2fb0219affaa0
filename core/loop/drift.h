#pragma once

#include "loop/keyframe_graph.h"

#include "map/map_snapshot.h"

#include "geometry/lie.h"

namespace glide {

/// Where one keyframe was measured from another: camera `to` in camera `from`, by a similarity
/// between their frames.
struct MeasuredLink {
  KeyframeId from, to;
  Sim3d S_from_to;
};

/// Whether the map can have drifted on the way between the two keyframes by what the measurement
/// differs from it. Repeated structure one period further on asks for far more.
bool isPlausibleDrift(const MeasuredLink& link, const MapSnapshot& map, const KeyframeGraph& graph);

}  // namespace glide
