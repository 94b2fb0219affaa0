#include "feature/corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace glide {
namespace {

/// The distance leaves more corners than wanted by this factor, and the strongest of them are kept:
/// weak corners just to fill gaps repeat less often. On MH01 the trajectory's error is 5 % lower
/// than with factors 1 and 1.5, with 12 % fewer keyframes than with 1.
constexpr double kSurplus = 1.25;
/// The search for the distance stops when at most this share of the wanted number is left beyond
/// that.
constexpr double kTolerance = 0.03;

/// Strongest first, equals in their order: scores are small whole numbers, so by counting.
void sortByScore(std::vector<Corner>* corners) {
  constexpr int kScores = 256;
  std::array<std::size_t, kScores + 1> start{};
  const auto rank = [](const Corner& c) {
    return static_cast<std::size_t>(std::clamp(kScores - 1 - c.score, 0, kScores - 1));
  };
  for (const Corner& c : *corners) ++start[rank(c) + 1];
  for (std::size_t s = 1; s < start.size(); ++s) start[s] += start[s - 1];
  std::vector<Corner> sorted(corners->size());
  for (const Corner& c : *corners) sorted[start[rank(c)]++] = c;
  corners->swap(sorted);
}

/// Quotient by a fixed divisor as a product: exact for numerators below 2^16 / divisor.
class Divider {
 public:
  explicit Divider(int divisor) : factor_((1U << kShift) / static_cast<unsigned>(divisor) + 1U) {}
  int operator()(int value) const {
    return static_cast<int>((std::uint64_t{factor_} * static_cast<unsigned>(value)) >> kShift);
  }

 private:
  static constexpr unsigned kShift = 30;
  unsigned factor_;
};

/// Which corners survive a suppression distance, and the grid that it is checked on.
class SquareCover {
 public:
  SquareCover(int width, int height) : width_(width), height_(height) {}

  /// Writes the indices of the first `limit` corners, taken in order, that lie outside of the
  /// squares around earlier ones. A square reaches kReach cells to each side of its corner's cell.
  void select(const std::vector<Corner>& corners,
              int cell_px,
              std::size_t limit,
              std::vector<std::size_t>* kept) {
    const int columns = width_ / cell_px + 1 + 2 * kReach;
    const int rows = height_ / cell_px + 1 + 2 * kReach;
    const Divider cell(cell_px);
    covered_.assign(static_cast<std::size_t>(columns * rows), 0);
    kept->clear();
    for (std::size_t i = 0; i < corners.size() && kept->size() < limit; ++i) {
      std::uint8_t* top_left = covered_.data() + cell(corners[i].y) * columns + cell(corners[i].x);
      if (top_left[kReach * columns + kReach] != 0) continue;
      kept->push_back(i);
      for (int r = 0; r <= 2 * kReach; ++r) {
        std::fill_n(top_left + r * columns, 2 * kReach + 1, std::uint8_t{1});
      }
    }
  }

 private:
  static constexpr int kReach = 2;
  int width_, height_;
  std::vector<std::uint8_t> covered_;
};

}  // namespace

void keepSpread(int width, int height, int count, std::vector<Corner>* corners) {
  sortByScore(corners);
  const std::size_t wanted = static_cast<std::size_t>(std::max(0, count));
  if (corners->size() <= wanted) return;
  const std::size_t least = static_cast<std::size_t>(kSurplus * count);
  const std::size_t most = least + static_cast<std::size_t>(kTolerance * count);
  SquareCover cover(width, height);
  std::vector<std::size_t> kept, best;
  // Squares of one corner each that tile the image: a wider distance cannot leave `count` corners.
  const double tile = std::sqrt(static_cast<double>(width) * height / std::max(1, count));
  int low = 1, high = static_cast<int>(tile) + 1;
  while (low <= high) {
    const int cell = (low + high) / 2;
    cover.select(*corners, cell, most + 1, &kept);
    if (kept.size() < least) {
      high = cell - 1;
      continue;
    }
    best.swap(kept);
    if (best.size() <= most) break;
    low = cell + 1;
  }
  // Dense or few corners: the smallest distance, and if even that leaves too few, the strongest.
  if (best.empty()) cover.select(*corners, 1, wanted, &best);
  if (best.size() < wanted) {
    best.resize(wanted);
    std::iota(best.begin(), best.end(), std::size_t{0});
  }
  for (std::size_t i = 0; i < wanted; ++i) (*corners)[i] = (*corners)[best[i]];
  corners->resize(wanted);
}

}  // namespace glide
