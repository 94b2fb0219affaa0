#pragma once

#include "map/map_snapshot.h"

#include "glide/map_view.h"

#include <memory>

namespace glide {

/// Copies a snapshot into the public view.
std::shared_ptr<const MapView> buildMapView(const MapSnapshot& snapshot, std::uint64_t resets);

}  // namespace glide
