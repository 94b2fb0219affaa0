#include "feature/corner.h"
#include "feature/fast_corners.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace glide {
namespace {

/// The cells of the part of a level in which corners are looked for.
struct Cells {
  int origin, width, height, columns, rows;

  Cells(const ImageViewU8& level, int border_px)
      : origin(border_px),
        width(level.width - 2 * border_px),
        height(level.height - 2 * border_px),
        columns(std::max(1, width / kThresholdCell)),
        rows(std::max(1, height / kThresholdCell)) {}
  std::size_t count() const { return static_cast<std::size_t>(columns * rows); }
  std::size_t of(const Corner& c) const {
    const int column = (c.x - origin) * columns / width;
    const int row = (c.y - origin) * rows / height;
    return static_cast<std::size_t>(row * columns + column);
  }
};

}  // namespace

void detectCorners(const ImageViewU8& level,
                   int border_px,
                   const CornerThresholds& thresholds,
                   std::vector<Corner>* corners) {
  corners->clear();
  const Cells cells(level, border_px);
  if (cells.width <= 0 || cells.height <= 0) return;
  fastCorners(level, border_px, std::min(thresholds.low, thresholds.high), corners);
  std::vector<std::uint8_t> has_strong(cells.count(), 0);
  for (const Corner& c : *corners) {
    if (c.score >= thresholds.high) has_strong[cells.of(c)] = 1;
  }
  const auto outdone = [&](const Corner& c) {
    return c.score < thresholds.high && has_strong[cells.of(c)] != 0;
  };
  corners->erase(std::remove_if(corners->begin(), corners->end(), outdone), corners->end());
}

}  // namespace glide
