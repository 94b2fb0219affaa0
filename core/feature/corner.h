#pragma once

#include "image/image.h"

#include <vector>

namespace glide {

/// A corner at a whole pixel of one pyramid level.
struct Corner {
  int x = 0, y = 0;
  float score = 0.0F;  ///< FAST score: the largest threshold at which it is still a corner
};

struct CornerThresholds {
  int high = 0;  ///< grey levels
  int low = 0;   ///< grey levels, for cells in which `high` finds nothing
};

/// FAST-9 corners (Rosten and Drummond 2006) that are local maxima of their score, at least
/// `border_px` from the borders of the level. Clears `corners` first. OpenCV may throw.
void detectCorners(const ImageViewU8& level,
                   int border_px,
                   const CornerThresholds& thresholds,
                   std::vector<Corner>* corners);

/// Keeps `count` corners (all when there are fewer), strong ones, evenly spread: no two of them are
/// closer than the largest distance that still leaves `count` (suppression via square covering,
/// Bailo et al., Pattern Recognition Letters 2018). Strongest first; ties by position.
void keepSpread(int width, int height, int count, std::vector<Corner>* corners);

}  // namespace glide
