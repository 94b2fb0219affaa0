#pragma once

#include "map/map.h"
#include "map/map_io.h"
#include "map/map_snapshot.h"

#include <cstdint>

namespace glide::test {

/// A map that has a bit of everything: patches, features without landmark, a culled keyframe, a
/// loop, a scale other than one. The same options give the same map.
struct SmallMapOptions {
  int keyframes = 4;  ///< before one of them is culled, at least 3
  int features = 8;   ///< per keyframe; a quarter of them observes nothing
  bool has_patches = true;
  std::uint64_t seed = 1;
};

Map smallMap(const SmallMapOptions& options);

/// Its snapshot with a camera, as it goes into a file.
StoredMap storedSmallMap(const SmallMapOptions& options);

/// A copy of the parts of a snapshot, to be changed.
MapSnapshot::Parts partsOf(const MapSnapshot& map);

}  // namespace glide::test
