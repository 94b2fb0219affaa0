#pragma once

#include "map/feature_refinement.h"
#include "map/map_snapshot.h"
#include "optimize/landmark_search.h"

#include <vector>

namespace glide {

/// Aligns the patch of each matched feature to the patch of the landmark in a keyframe that saw it
/// from a similar direction: sub-pixel observations for the pose and the map.
std::vector<FeatureMove> refineMatches(const RefinementContext& context,
                                       const MapSnapshot& map,
                                       const SE3d& T_cam_world,
                                       const FeatureSet& features,
                                       const LandmarkMatches& matches);

}  // namespace glide
