#pragma once

#include "geometry/eigen_types.h"
#include "image/image.h"

namespace glide {

/// Pixels around a corner that refineCorner reads.
inline constexpr int kRefineReach = 4;

/// Sub-pixel position of the corner found at pixel (x, y): the point that is nearest to all the
/// edge lines through its neighbourhood (Foerstner and Guelch 1987). Moves by at most one pixel
/// along each axis; where the neighbourhood does not fix the point (an edge) it stays at (x, y).
Vec2f refineCorner(const ImageViewU8& image, int x, int y);

}  // namespace glide
