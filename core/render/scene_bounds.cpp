#include "render/scene_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glide {
namespace {

/// Landmarks beyond these shares of each axis are outliers: badly triangulated or far away.
constexpr double kLowShare = 0.05, kHighShare = 0.95;
/// So many landmarks tell the range of all of them.
constexpr std::size_t kMaxSample = 4096;
/// A scene without extent (one landmark) still needs some.
constexpr float kMinRadius = 1e-3F;

struct Range {
  float low = 0.0F, high = 0.0F;
};

float quantile(std::vector<float>* values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values->size() - 1));
  std::nth_element(values->begin(), values->begin() + rank, values->end());
  return (*values)[static_cast<std::size_t>(rank)];
}

/// One coordinate of the landmarks, or of as many as tell its range.
std::vector<float> coordinates(std::span<const LandmarkRecord> landmarks, std::size_t axis) {
  const std::size_t stride = (landmarks.size() + kMaxSample - 1) / kMaxSample;
  std::vector<float> values;
  for (std::size_t i = 0; i < landmarks.size(); i += stride)
    values.push_back(landmarks[i].p_world[axis]);
  return values;
}

/// Of these, without the outliers.
Range rangeOf(std::vector<float>* values) {
  return {quantile(values, kLowShare), quantile(values, kHighShare)};
}

/// SceneBounds::heights from the y of landmarks, which points down.
std::array<float, kHeightSteps + 1> heightsOf(std::vector<float>* downs) {
  std::array<float, kHeightSteps + 1> heights{};
  for (std::size_t i = 0; i <= kHeightSteps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(kHeightSteps);
    heights[i] = -quantile(downs, kHighShare - part * (kHighShare - kLowShare));
  }
  return heights;
}

Range unite(const Range& range, std::span<const PoseRecord> cameras, std::size_t axis) {
  Range all = range;
  for (const PoseRecord& camera : cameras) {
    all.low = std::min(all.low, camera.p_world[axis]);
    all.high = std::max(all.high, camera.p_world[axis]);
  }
  return all;
}

}  // namespace

SceneBounds boundsOf(std::span<const LandmarkRecord> landmarks,
                     std::span<const PoseRecord> cameras) {
  constexpr std::size_t kDown = 1;  // the world's y axis
  SceneBounds bounds;
  if (landmarks.empty() && cameras.empty()) return bounds;
  float squared_radius = 0.0F;
  for (std::size_t axis = 0; axis < bounds.center.size(); ++axis) {
    const float first = cameras.empty() ? 0.0F : cameras.front().p_world[axis];
    Range inner{first, first};
    if (!landmarks.empty()) {
      std::vector<float> values = coordinates(landmarks, axis);
      inner = rangeOf(&values);
      bounds.landmarks_low[axis] = inner.low;
      bounds.landmarks_high[axis] = inner.high;
      if (axis == kDown) bounds.heights = heightsOf(&values);
    }
    const Range all = unite(inner, cameras, axis);
    bounds.center[axis] = 0.5F * (all.low + all.high);
    const float half = 0.5F * (all.high - all.low);
    squared_radius += half * half;
  }
  bounds.radius = std::max(std::sqrt(squared_radius), kMinRadius);
  return bounds;
}

}  // namespace glide
