#pragma once

#include "replay/outputs/point_colors.h"

#include "glide/map_view.h"

#include <string>

namespace glide::replay {

/// map.ply: the landmarks as a point cloud, binary little-endian PLY. A vertex is `float x y z` in
/// the map's world, `uchar red green blue` and `int observations`, the number of keyframes that see
/// it.
std::string mapPly(const MapView& map, const PointColors& colors);

}  // namespace glide::replay
