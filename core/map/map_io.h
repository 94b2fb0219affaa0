#pragma once

#include "map/map_snapshot.h"

#include "glide/result.h"
#include "glide/types.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace glide {

/// A map with what it was made with. Format: docs/map-format.md.
struct StoredMap {
  std::shared_ptr<const MapSnapshot> map;
  CameraIntrinsics camera;
  ScaleLevels levels;
};

/// The bytes of a map file. Equal maps give equal bytes.
std::vector<std::byte> encodeMap(const StoredMap& stored);

/// io error that says what is wrong: not a map, unknown version, truncated, damaged (checksum), or
/// contents that contradict each other. Allocates no more than a small multiple of the input.
Result<StoredMap> decodeMap(std::span<const std::byte> bytes);

}  // namespace glide
