#include "feature/orientation_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace glide {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;
/// Bins of 10 degrees: the scatter of the centroid's direction between two views.
constexpr int kBins = 36;
/// Bins on each side of the peak that still agree with it.
constexpr int kReach = 2;

int binOf(float angle_a, float angle_b) {
  const double turns = (static_cast<double>(angle_b) - static_cast<double>(angle_a)) / kTurn;
  return static_cast<int>((turns - std::floor(turns)) * kBins) % kBins;
}

int circularDistance(int a, int b) {
  const int d = std::abs(a - b);
  return std::min(d, kBins - d);
}

}  // namespace

void keepConsistentRotation(const FeatureSet& a, const FeatureSet& b, std::vector<Match>* matches) {
  const auto bin = [&](const Match& m) {
    return binOf(a.feature(static_cast<std::size_t>(m.a)).angle,
                 b.feature(static_cast<std::size_t>(m.b)).angle);
  };
  std::array<int, kBins> smooth{};  // each match votes for its bin and the two beside it
  for (const Match& m : *matches) {
    for (int side = -1; side <= 1; ++side) {
      ++smooth[static_cast<std::size_t>((bin(m) + side + kBins) % kBins)];
    }
  }
  const int peak =
      static_cast<int>(std::max_element(smooth.begin(), smooth.end()) - smooth.begin());
  const auto disagrees = [&](const Match& m) { return circularDistance(bin(m), peak) > kReach; };
  matches->erase(std::remove_if(matches->begin(), matches->end(), disagrees), matches->end());
}

}  // namespace glide
