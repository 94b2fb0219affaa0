#pragma once

#include "feature/feature_set.h"

#include <optional>

namespace glide {

/// Where in `target` the corner of `source` lies, px of the target's level from its patch centre:
/// translation by inverse-compositional Lucas-Kanade (Baker and Matthews 2004) on mean-free 8x8
/// patches, started at the target's own corner. `A_target_source` maps small offsets from source
/// level pixels to target level pixels. Nothing when it does not converge nearby or the patches do
/// not look alike.
std::optional<Vec2f> alignPatch(const FeaturePatch& source,
                                const FeaturePatch& target,
                                const Eigen::Matrix2f& A_target_source);

}  // namespace glide
