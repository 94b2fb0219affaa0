#pragma once

#include "map/map.h"
#include "map/map_snapshot.h"

#include <cstdint>
#include <memory>

namespace glide {

struct SnapshotStamp {
  std::uint64_t revision = 0;
  std::uint64_t generation = 0;
  std::uint64_t corrections = 0;
  int min_covisibility = 1;
  std::shared_ptr<const CameraModel> camera = nullptr;  ///< null: as given
};

/// Copies the map into an immutable value. Features are shared, poses and links copied. A
/// keyframe's neighbours are those that share at least `min_covisibility` landmarks, or the best
/// one.
std::shared_ptr<const MapSnapshot> snapshotOf(const Map& map, const SnapshotStamp& stamp);

}  // namespace glide
