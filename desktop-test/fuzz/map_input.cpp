#include "fuzz/map_input.h"

#include "support/small_map.h"

#include "map/map_consistency.h"
#include "map/map_header.h"
#include "map/map_io.h"
#include "map/map_restore.h"
#include "map/snapshot_builder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace glide::test {
namespace {

using Bytes = std::vector<std::byte>;

void demand(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "map fuzzing: %s\n", what.c_str());
  std::abort();
}

void tryOnce(std::span<const std::byte> file) {
  const Result<StoredMap> decoded = decodeMap(file);
  if (!decoded.ok()) {
    demand(!decoded.error().message.empty(), "an error without words");
    return;
  }
  const Bytes again = encodeMap(*decoded);
  demand(std::equal(again.begin(), again.end(), file.begin(), file.end()), "not written as read");
  Map map(decoded->levels);
  restoreMap(*decoded->map, &map);
  demand(checkConsistency(map).empty(), checkConsistency(map));
  for (const LandmarkId id : map.landmarkIds()) map.refreshGeometry(id);
  SnapshotStamp stamp;
  stamp.min_covisibility = 1;
  demand(snapshotOf(map, stamp)->landmarks().size() == decoded->map->landmarks().size(),
         "a landmark got lost");
}

}  // namespace

void tryMapFile(std::span<const std::byte> file) {
  tryOnce(file);
  Bytes sealed(file.begin(), file.end());
  sealMapFile(sealed);
  tryOnce(sealed);
}

std::vector<std::vector<std::byte>> seedFiles() {
  std::vector<Bytes> files;
  std::uint64_t seed = 1;
  for (const int keyframes : {3, 6}) {
    for (const int features : {4, 9}) {
      for (const bool has_patches : {false, true}) {
        files.push_back(encodeMap(storedSmallMap({keyframes, features, has_patches, seed++})));
      }
    }
  }
  StoredMap empty = storedSmallMap({});
  empty.map = std::make_shared<const MapSnapshot>();
  empty.camera.distortion = DistortionModel::radial_tangential;
  empty.camera.coefficients = {-0.3, 0.1, 0.001, -0.001, 0.01};
  files.push_back(encodeMap(empty));
  return files;
}

}  // namespace glide::test
