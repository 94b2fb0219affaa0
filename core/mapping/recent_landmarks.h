#pragma once

#include "map/map.h"

#include <vector>

namespace glide {

/// Landmarks on probation. One must be found in at least a quarter of the frames that expected it,
/// and be seen by three keyframes within the two that follow its creation.
class RecentLandmarks {
 public:
  void add(const std::vector<LandmarkId>& created);

  /// Call once per inserted keyframe: removes the failures from the map, releases the others after
  /// three keyframes.
  void cull(Map* map);

  void clear() { entries_.clear(); }

 private:
  struct Entry {
    LandmarkId id;
    int age = 0;  // keyframes since creation
  };
  std::vector<Entry> entries_;
};

}  // namespace glide
