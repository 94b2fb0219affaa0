#pragma once

#include "map/map.h"
#include "map/map_snapshot.h"

namespace glide {

/// Makes `map` equal to the snapshot. Keyframe and landmark ids go on above the snapshot's.
void restoreMap(const MapSnapshot& snapshot, Map* map);

}  // namespace glide
