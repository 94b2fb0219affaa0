#pragma once

#include "map/map.h"
#include "map/messages.h"

namespace glide {

/// Bends the map as the loop demands: keyframes and their scales, landmarks with a keyframe that
/// sees them, what is newer than the correction along with its covisible keyframes; then fuses the
/// landmarks that are the same and remembers the edge.
void applyCorrection(const LoopCorrection& correction, Map* map);

/// Takes over the result of global bundle adjustment; what is newer than it follows its covisible
/// keyframes.
void applyAdjustment(const GlobalAdjustment& adjustment, Map* map);

}  // namespace glide
