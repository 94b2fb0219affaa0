#pragma once

#include "loop/landmark_matching.h"

#include "map/landmark.h"
#include "map/map_snapshot.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <span>
#include <vector>

namespace glide {

/// What a keyframe should see of some landmarks, and what it does see of them.
struct ProjectedSearch {
  std::vector<LandmarkMatch> matches;  ///< ascending feature
  int expected = 0;                    ///< landmarks in view, near enough and not from behind
};

struct ProjectedSearchOptions {
  double radius_px = 0.0;  ///< at scale level 0
  int max_distance = 64;   ///< descriptor bits
  double ratio = 0.9;      ///< best over second best in the window
};

/// A camera whose position in the world of the landmarks is assumed; its unit of length may be
/// another.
struct AssumedView {
  const FeatureSet& features;
  Sim3d S_cam_world;
};

/// Looks for landmarks around their projections, at the scale that their distance predicts.
ProjectedSearch searchProjected(const CameraModel& camera,
                                const ScaleLevels& levels,
                                const AssumedView& view,
                                std::span<const MapSnapshot::LandmarkEntry* const> landmarks,
                                const ProjectedSearchOptions& options);

}  // namespace glide
