#pragma once

#include "map/map.h"
#include "map/map_snapshot.h"

#include <cstdint>
#include <memory>

namespace glide {

/// Copies the map into an immutable value. Features are shared, poses and links copied. A
/// keyframe's neighbours are those that share at least `min_covisibility` landmarks, or the best
/// one.
std::shared_ptr<const MapSnapshot> snapshotOf(const Map& map,
                                              std::uint64_t revision,
                                              int min_covisibility);

}  // namespace glide
