#pragma once

#include "mapping/mapper_state.h"

#include <atomic>

namespace glide {

/// Projects the keyframe's landmarks into its covisible keyframes and their neighbours, and theirs
/// into it: a feature without landmark becomes an observation, two landmarks on one feature become
/// one. `interrupt` (may be null): only the direct neighbours take part.
void fuseAround(MapperState* state, KeyframeId id, const std::atomic<bool>* interrupt);

}  // namespace glide
