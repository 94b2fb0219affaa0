#pragma once

#include "loop/placement.h"

#include <span>

namespace glide {

/// Whether so much speaks for a placement that it may be given out: enough landmarks, a share of
/// those expected, few that contradict, spread over the image, and a pose that they determine well.
bool isBeyondDoubt(const Placement& placement);

/// Whether another placement than the first explains the frame nearly as well. `placements`: most
/// inliers first, all distinct.
bool areAmbiguous(std::span<const Placement> placements);

}  // namespace glide
