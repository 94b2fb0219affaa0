#pragma once

#include "map/map_snapshot.h"

#include "base/ids.h"

#include <span>
#include <vector>

namespace glide {

/// A feature of a keyframe looks like a landmark of another place.
struct LandmarkMatch {
  int feature = 0;
  const MapSnapshot::LandmarkEntry* landmark = nullptr;
};

/// The landmarks that these keyframes see, ascending by id.
std::vector<const MapSnapshot::LandmarkEntry*> landmarksOf(const MapSnapshot& map,
                                                           std::span<const KeyframeId> keyframes);

/// Features of the keyframe that have a landmark of their own, with that among `landmarks` which
/// looks most alike: mutual best, clearly better than any other that lies elsewhere (near ones may
/// be the same corner, mapped twice).
std::vector<LandmarkMatch> matchByLook(
    const MapSnapshot::KeyframeEntry& keyframe,
    const MapSnapshot& map,
    std::span<const MapSnapshot::LandmarkEntry* const> landmarks);

}  // namespace glide
