#pragma once

#include "loop/place_groups.h"

#include "feature/feature_set.h"
#include "map/map_snapshot.h"

#include "geometry/camera_model.h"

#include <vector>

namespace glide {

/// A pose that some descriptor matches agree on.
struct PoseSuggestion {
  SE3d T_cam_world;
  std::vector<LandmarkId> seen;  ///< landmarks of those matches
};

/// Matches the landmarks of a group's keyframes with a frame by descriptors alone and looks for
/// poses that explain the matches (P3P, RANSAC). At most two, the better one first: where the
/// second is another pose, the place looks the same from both. Empty when no pose explains enough.
std::vector<PoseSuggestion> suggestPoses(const CameraModel& camera,
                                         const MapSnapshot& map,
                                         const PlaceGroup& group,
                                         const FeatureSet& features);

}  // namespace glide
