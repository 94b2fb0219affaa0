#pragma once

#include "map/map_snapshot.h"

#include <span>
#include <vector>

namespace glide {

/// The part of a map around a camera.
struct LocalMap {
  KeyframeId reference;         ///< shares the most landmarks with the frame
  int reference_landmarks = 0;  ///< of the reference keyframe
  std::vector<const MapSnapshot::LandmarkEntry*>
      landmarks;  ///< each once; live as long as the snapshot
};

struct LocalMapLimits {
  int max_keyframes = 20;
  int max_landmarks = 2500;
};

/// Keyframes that see the given landmarks, most shared first, then their covisible neighbours, and
/// what all of them see. Empty landmarks in `seen` are kNoLandmark.
LocalMap collectLocalMap(const MapSnapshot& map,
                         std::span<const LandmarkId> seen,
                         const LocalMapLimits& limits);

/// Landmarks of one keyframe.
std::vector<const MapSnapshot::LandmarkEntry*> landmarksOf(const MapSnapshot& map,
                                                           std::span<const LandmarkId> ids);

}  // namespace glide
