#include "feature/corner.h"

#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace glide {
namespace {

/// Side of a cell of the two-threshold rule, px.
constexpr int kCellSize = 32;
/// cv::FAST leaves out this many pixels at each border of what it is given: the circle's radius.
constexpr int kFastMargin = 3;

/// Part of a level in which corners are looked for, and the cells it is divided into.
struct Region {
  cv::Rect area;
  int columns = 0, rows = 0;

  explicit Region(const cv::Rect& area_in)
      : area(area_in),
        columns(std::max(1, area_in.width / kCellSize)),
        rows(std::max(1, area_in.height / kCellSize)) {}
  int columnStart(int column) const { return area.x + area.width * column / columns; }
  int rowStart(int row) const { return area.y + area.height * row / rows; }
  std::size_t cellAt(int x, int y) const {
    const int column = (x - area.x) * columns / area.width;
    const int row = (y - area.y) * rows / area.height;
    return static_cast<std::size_t>(row * columns + column);
  }
};

void appendCorners(const cv::Mat& image,
                   const cv::Rect& area,
                   int threshold,
                   std::vector<Corner>* corners) {
  const cv::Rect with_margin(area.x - kFastMargin,
                             area.y - kFastMargin,
                             area.width + 2 * kFastMargin,
                             area.height + 2 * kFastMargin);
  std::vector<cv::KeyPoint> found;
  cv::FAST(image(with_margin), found, threshold, true);
  for (const cv::KeyPoint& k : found) {
    corners->push_back({static_cast<int>(k.pt.x) + with_margin.x,
                        static_cast<int>(k.pt.y) + with_margin.y,
                        k.response});
  }
}

}  // namespace

void detectCorners(const ImageViewU8& level,
                   int border_px,
                   const CornerThresholds& thresholds,
                   std::vector<Corner>* corners) {
  corners->clear();
  const cv::Rect area(
      border_px, border_px, level.width - 2 * border_px, level.height - 2 * border_px);
  if (area.width <= 0 || area.height <= 0) return;
  // cv::Mat has no read-only form; nothing here writes to it.
  const cv::Mat image(level.height,
                      level.width,
                      CV_8UC1,
                      const_cast<std::uint8_t*>(level.data),
                      static_cast<std::size_t>(level.stride));
  const Region region(area);
  appendCorners(image, area, thresholds.high, corners);
  std::vector<std::uint8_t> occupied(static_cast<std::size_t>(region.columns * region.rows), 0);
  for (const Corner& c : *corners) occupied[region.cellAt(c.x, c.y)] = 1;
  for (int row = 0; row < region.rows; ++row) {
    const std::uint8_t* cells = occupied.data() + row * region.columns;
    const int top = region.rowStart(row), bottom = region.rowStart(row + 1);
    for (int column = 0; column < region.columns;) {
      int end = column;
      while (end < region.columns && cells[end] == 0) ++end;  // a run of empty cells: one call
      if (end > column) {
        const int left = region.columnStart(column), right = region.columnStart(end);
        const cv::Rect run(left, top, right - left, bottom - top);
        appendCorners(image, run, thresholds.low, corners);
      }
      column = end + 1;
    }
  }
}

}  // namespace glide
