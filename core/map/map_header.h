#pragma once

#include "map/landmark.h"

#include "glide/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glide {

/// What is wrong with a file; nothing when nothing is.
using MapFault = std::optional<std::string>;

/// Sections of a map file, in the file's order.
enum class MapSection { keyframes, features, patches, landmarks, retired, loops };
inline constexpr std::size_t kMapSections = 6;

/// Bytes before the first section.
inline constexpr std::size_t kMapHeaderBytes = 176;

/// Sides of an image that a map file may have, px.
inline constexpr int kMaxMapImageSide = 65535;

/// The start of a map file (docs/map-format.md).
struct MapHeader {
  std::uint64_t revision = 0;
  CameraIntrinsics camera;
  double level_factor = 1.2;
  int level_count = 1;
  std::array<std::uint32_t, kMapSections> counts{};  ///< records of each section

  std::uint32_t count(MapSection section) const {
    return counts[static_cast<std::size_t>(section)];
  }
  std::uint64_t offset(MapSection section) const;  ///< bytes from the start of the file
  std::uint64_t fileBytes() const;
};

/// Appends the header with a checksum of zero.
void writeMapHeader(const MapHeader& header, std::vector<std::byte>* bytes);

/// Writes the checksum of a whole map file into its header. Nothing happens when the file is
/// shorter than a header.
void sealMapFile(std::span<std::byte> file);

/// Whether this is a map file, but of a version that this library does not read.
bool isOtherMapVersion(std::span<const std::byte> file);

/// Checks magic, version, sizes and the checksum of a whole file, and what the header says of
/// camera and scale levels.
MapFault readMapHeader(std::span<const std::byte> file, MapHeader* header);

}  // namespace glide
