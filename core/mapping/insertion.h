#pragma once

#include "mapping/mapper_state.h"

#include "map/messages.h"

namespace glide {

/// Puts a tracked frame into the map: pose from the present pose of its reference, re-optimised
/// against the present landmarks; observations whose landmark is gone or that do not fit are left
/// out. A keyframe with too few observations to hold its place is retired at once, so that its pose
/// stays defined. True when the keyframe lives. False without any change when its reference is
/// unknown (of a map that was dropped) or its id is not newer than the map's.
bool insertKeyframe(MapperState* state, const NewKeyframe& message);

}  // namespace glide
