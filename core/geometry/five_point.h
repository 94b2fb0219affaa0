#pragma once

#include "geometry/ray_pair.h"

#include <array>
#include <vector>

namespace glide {

/// Pairs of one minimal sample.
inline constexpr std::size_t kFivePoints = 5;
using FivePairs = std::array<const RayPair*, kFivePoints>;

/// All real essential matrices, bearing_b^T E bearing_a = 0, through five pairs (at most ten; none
/// for degenerate samples). Stewenius, Engels and Nister, "Recent developments on direct relative
/// orientation", ISPRS 2006. Planar scenes are no degenerate case.
std::vector<Mat3d> essentialsFromFivePairs(const FivePairs& pairs);

}  // namespace glide
