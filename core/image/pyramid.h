#pragma once

#include "image/image.h"

#include <vector>

namespace glide {

/// Float grey levels 0..255; level l has ceil-halved size: w_l = (w_{l-1} + 1) / 2, pixel (x, y) of
/// level l lies at (2x, 2y) of level l-1.
struct Pyramid {
  std::vector<ImageF> levels;
  std::vector<float> blurred_row;  ///< scratch of buildPyramid: a frame allocates nothing
};

/// Level 0 converts; each next level is a separable 5-tap binomial blur (1 4 6 4 1)/16 of the
/// previous one, borders clamped, then decimation by two (paper section III-C). Reuses the buffers
/// of `out`. Levels that would be smaller than 8 px on a side are not built, level 0 always is. The
/// image has at least one pixel; nothing outside of its rows is read.
void buildPyramid(const ImageViewU8& luma, int levels, Pyramid* out);

/// Number of levels that buildPyramid makes for such an image, at most `levels`.
int pyramidLevels(int width, int height, int levels);

}  // namespace glide
