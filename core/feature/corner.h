#pragma once

#include "image/image.h"

#include <vector>

namespace glide {

/// A corner at a whole pixel of one pyramid level.
struct Corner {
  int x = 0, y = 0;
  int score = 0;  ///< FAST score: the largest threshold at which it is still a corner, 1..254
};

struct CornerThresholds {
  int high = 0;  ///< grey levels
  int low = 0;   ///< grey levels, for cells in which `high` finds nothing
};

/// Side of a cell of the two-threshold rule, px.
inline constexpr int kThresholdCell = 32;

/// FAST-9 corners at least `border_px` from the borders: those of at least thresholds.high, and
/// where a cell of about kThresholdCell has none of them, those of at least thresholds.low. Clears
/// `corners` first. `level` and `border_px` as for fastCorners.
void detectCorners(const ImageViewU8& level,
                   int border_px,
                   const CornerThresholds& thresholds,
                   std::vector<Corner>* corners);

/// Keeps `count` corners (all when there are fewer): those that are the strongest within a distance
/// that leaves somewhat more than `count` (suppression via square covering, Bailo et al., Pattern
/// Recognition Letters 2018), and of them the strongest. Strongest first; of equals, the order they
/// came in.
void keepSpread(int width, int height, int count, std::vector<Corner>* corners);

}  // namespace glide
