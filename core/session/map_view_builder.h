#pragma once

#include "map/map_snapshot.h"

#include "glide/map_view.h"

#include <memory>

namespace glide {

/// What the session knows about a map besides.
struct MapStamp {
  std::uint64_t generation = 0, resets = 0;  ///< as in MapView
};

/// Copies a snapshot into the public view.
std::shared_ptr<const MapView> buildMapView(const MapSnapshot& snapshot, const MapStamp& stamp);

}  // namespace glide
