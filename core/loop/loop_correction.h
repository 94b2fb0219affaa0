#pragma once

#include "loop/keyframe_graph.h"
#include "loop/loop_verifier.h"

#include "map/map_snapshot.h"
#include "map/messages.h"

#include <atomic>
#include <optional>
#include <vector>

namespace glide {

/// How each keyframe has to move so that the loop closes, ascending by id: a pose graph over the
/// essential links of the map, earlier loops and the new one, with the oldest keyframe fixed
/// (Strasdat et al. 2010). `cancel` may be null. Nothing when cancelled or not solvable.
std::optional<std::vector<KeyframeMove>> bendMap(const LoopGeometry& loop,
                                                 const MapSnapshot& map,
                                                 const KeyframeGraph& graph,
                                                 const std::atomic<bool>* cancel);

}  // namespace glide
