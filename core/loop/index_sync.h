#pragma once

#include "map/map_snapshot.h"
#include "map/place_index.h"

#include <cstdint>
#include <set>

namespace glide {

/// Keeps a place index in step with the map: adds keyframes that are new, removes those that were
/// culled. Owned by the loop thread.
class IndexSync {
 public:
  void update(const MapSnapshot& map, PlaceIndex* index);

 private:
  std::set<KeyframeId> indexed_;
  std::uint64_t generation_ = 0;
};

}  // namespace glide
