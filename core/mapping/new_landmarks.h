#pragma once

#include "mapping/mapper_state.h"

#include <atomic>
#include <vector>

namespace glide {

/// Matches the keyframe's features without landmark to those of its best covisible neighbours and
/// triangulates what passes: parallax, positive depth, reprojection chi2 in both views, agreement
/// of scale. `interrupt` (may be null): only the first few neighbours are searched. Ids are
/// ascending.
std::vector<LandmarkId> createLandmarks(MapperState* state,
                                        KeyframeId id,
                                        const std::atomic<bool>* interrupt);

/// Median distance of the keyframe's landmarks along its optical axis; 0 when it sees none in
/// front.
double medianDepth(const Map& map, const Keyframe& keyframe);

}  // namespace glide
