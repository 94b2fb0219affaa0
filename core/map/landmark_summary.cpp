#include "map/landmark_summary.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace glide {
namespace {

// A camera on top of the point has no direction to it.
constexpr double kMinDistance = 1e-9;

}  // namespace

ViewingRange viewingRange(const Vec3d& p_world,
                          std::span<const LandmarkSight> sights,
                          const ScaleLevels& levels) {
  assert(!sights.empty());
  Vec3d direction = Vec3d::Zero();
  double log_max_distance = 0.0;
  for (const LandmarkSight& sight : sights) {
    const Vec3d ray = p_world - sight.center_world;
    const double distance = std::max(ray.norm(), kMinDistance);
    direction += ray / distance;
    log_max_distance += std::log(distance * levels.scale(sight.level));
  }
  ViewingRange range;
  range.normal = direction.normalized();
  range.max_distance = std::exp(log_max_distance / static_cast<double>(sights.size()));
  range.min_distance = range.max_distance / levels.scale(levels.count() - 1);
  return range;
}

std::size_t medoid(std::span<const Descriptor* const> descriptors) {
  assert(!descriptors.empty());
  const std::size_t count = descriptors.size();
  std::vector<int> distances(count * count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const int distance = descriptorDistance(*descriptors[i], *descriptors[j]);
      distances[i * count + j] = distances[j * count + i] = distance;
    }
  }
  std::size_t best = 0;
  int best_median = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = distances.begin() + static_cast<std::ptrdiff_t>(i * count);
    const auto middle = row + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(row, middle, row + static_cast<std::ptrdiff_t>(count));
    if (*middle < best_median) {
      best_median = *middle;
      best = i;
    }
  }
  return best;
}

}  // namespace glide
