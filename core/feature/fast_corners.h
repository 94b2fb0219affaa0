#pragma once

#include "feature/corner.h"

#include "geometry/eigen_types.h"
#include "image/image.h"

#include <span>
#include <vector>

namespace glide {

/// Border that both functions below need, px. They read whole vectors: beyond the last row read the
/// image's memory must go on for 64 elements, as that of Image does.
inline constexpr int kFastReach = 5;

/// FAST-9 corners (Rosten and Drummond 2006) of score `min_score` (1..254) or more whose score is
/// the largest among their eight neighbours', at least `border_px` (>= kFastReach) from the
/// borders, in reading order. Of equal neighbours the first is taken. Clears `corners` first.
void fastCorners(const ImageViewU8& image,
                 int border_px,
                 int min_score,
                 std::vector<Corner>* corners);

/// Sub-pixel positions of corners that fastCorners found: the centroid of the squared FAST scores
/// (of the corner's sign, bright or dark, above the smallest) of the 5x5 pixels around. The median
/// epipolar error of matches is 29 % (EuRoC MH01) and 38 % (KITTI 07) smaller than with whole
/// pixels; with a quadric fitted to the scores 26 % and 36 %. The Foerstner point is worse than
/// whole pixels: it is another point than the one that the detector repeats. `uv` has the length of
/// `corners`.
void refineCorners(const ImageViewU8& image, std::span<const Corner> corners, std::span<Vec2f> uv);

}  // namespace glide
