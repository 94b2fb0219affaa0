#pragma once

#include "mapping/mapper_state.h"

namespace glide {

/// Retires covisible keyframes of `id` of whose landmarks more than
/// Config::Mapping::redundant_ratio are seen by at least three others at the same or a finer level.
/// Never the map's first keyframe and never its newest two.
void cullRedundantKeyframes(MapperState* state, KeyframeId id);

}  // namespace glide
