#pragma once

#include "map/map_snapshot.h"
#include "map/place_index.h"

#include <set>

namespace glide {

/// Keeps a place index in step with the map: adds keyframes that are new, removes those that were
/// culled. Owned by the loop thread.
class IndexSync {
 public:
  void update(const MapSnapshot& map, PlaceIndex* index);

 private:
  std::set<KeyframeId> indexed_;
};

}  // namespace glide
