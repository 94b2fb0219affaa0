#pragma once

#include "mapping/mapper_state.h"

#include "map/messages.h"

namespace glide {

/// Replaces the map by two keyframes and their points: full bundle adjustment with the first camera
/// fixed, outliers removed, then scaled about the first camera so that the median depth of its
/// landmarks is Config::Initialization::median_depth. False, and the map is empty, when fewer than
/// half of Config::Initialization::min_landmarks survive: the pair was no two-view geometry after
/// all.
bool startMap(MapperState* state, const InitialMap& message);

}  // namespace glide
