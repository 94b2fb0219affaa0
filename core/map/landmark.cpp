#include "map/landmark.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace glide {
namespace {

// Rounding must not push a landmark that sits exactly on a level to the next one.
constexpr double kLevelTolerance = 1e-6;

}  // namespace

ScaleLevels::ScaleLevels(double factor, int count) : factor_(factor), count_(count) {
  assert(factor > 1.0 && count >= 1 && count <= kMaxLevels);
  double scale = 1.0;
  for (double& entry : scale_) {
    entry = scale;
    scale *= factor;
  }
}

double ScaleLevels::scale(int level) const {
  return scale_[static_cast<std::size_t>(std::clamp(level, 0, count_ - 1))];
}

int predictedLevel(const ScaleLevels& levels, double max_distance, double distance) {
  if (distance >= max_distance) return 0;
  if (distance <= 0.0) return levels.count() - 1;
  const double level = std::log(max_distance / distance) / std::log(levels.factor());
  return static_cast<int>(
      std::min(std::ceil(level - kLevelTolerance), static_cast<double>(levels.count() - 1)));
}

}  // namespace glide
