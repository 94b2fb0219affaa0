#include "feature/corner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace glide {
namespace {

/// The search for the suppression distance stops when at most this share too many are left.
constexpr double kTolerance = 0.03;

/// Which corners survive a suppression distance, and the grid that it is checked on.
class SquareCover {
 public:
  SquareCover(int width, int height) : width_(width), height_(height) {}

  /// Writes the indices of the corners, taken in order, that lie in no square of 2 * (2 * cell_px)
  /// side around an earlier one.
  void select(const std::vector<Corner>& corners, int cell_px, std::vector<int>* kept) {
    const int columns = width_ / cell_px + 1 + 2 * kReach;
    const int rows = height_ / cell_px + 1 + 2 * kReach;
    covered_.assign(static_cast<std::size_t>(columns * rows), 0);
    kept->clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int column = corners[i].x / cell_px, row = corners[i].y / cell_px;
      std::uint8_t* top_left = covered_.data() + row * columns + column;
      if (top_left[kReach * columns + kReach] != 0) continue;
      kept->push_back(static_cast<int>(i));
      for (int r = 0; r <= 2 * kReach; ++r) {
        std::fill_n(top_left + r * columns, 2 * kReach + 1, std::uint8_t{1});
      }
    }
  }

 private:
  static constexpr int kReach = 2;  ///< cells covered on each side of a kept corner's cell
  int width_, height_;
  std::vector<std::uint8_t> covered_;
};

bool stronger(const Corner& a, const Corner& b) {
  return std::tie(b.score, a.y, a.x) < std::tie(a.score, b.y, b.x);
}

}  // namespace

void keepSpread(int width, int height, int count, std::vector<Corner>* corners) {
  std::sort(corners->begin(), corners->end(), stronger);
  const std::size_t wanted = static_cast<std::size_t>(std::max(0, count));
  if (corners->size() <= wanted) return;
  const std::size_t most = wanted + static_cast<std::size_t>(kTolerance * count);
  SquareCover cover(width, height);
  std::vector<int> kept, best;
  int low = 1, high = std::max(width, height);
  while (low <= high) {
    const int cell = (low + high) / 2;
    cover.select(*corners, cell, &kept);
    if (kept.size() < wanted) {
      high = cell - 1;
      continue;
    }
    best.swap(kept);
    if (best.size() <= most) break;
    low = cell + 1;
  }
  if (best.empty()) {  // even the smallest distance leaves too few: the strongest it is
    corners->resize(wanted);
    return;
  }
  best.resize(wanted);
  std::vector<Corner> result;
  result.reserve(wanted);
  for (const int i : best) result.push_back((*corners)[static_cast<std::size_t>(i)]);
  corners->swap(result);
}

}  // namespace glide
