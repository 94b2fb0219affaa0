#pragma once

#include "map/map_snapshot.h"
#include "map/place_index.h"

#include <span>
#include <vector>

namespace glide {

/// Keyframes that resemble an image and show one part of the map, most alike first.
struct PlaceGroup {
  std::vector<const MapSnapshot::KeyframeEntry*> keyframes;  ///< live as long as the snapshot
  double score = 0.0;                                        ///< sum of PlaceMatch::score
};

struct PlaceGroupLimits {
  std::size_t max_groups = 3;
  std::size_t max_keyframes = 2;   ///< per group
  std::size_t max_neighbors = 10;  ///< of the first keyframe, best first, that may join its group
};

/// Groups `matches` (best first): each keyframe joins the first group whose first keyframe counts
/// it among its best neighbours, or begins a new one. Keyframes that `map` does not have are passed
/// over. Groups with a higher score come first.
std::vector<PlaceGroup> groupPlaces(const MapSnapshot& map,
                                    std::span<const PlaceMatch> matches,
                                    const PlaceGroupLimits& limits);

}  // namespace glide
