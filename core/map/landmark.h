#pragma once

#include <vector>

#include "base/ids.h"
#include "feature/feature_set.h"
#include "geometry/eigen_types.h"

namespace glide {

/// Feature `feature` of keyframe `keyframe` sees the landmark.
struct Observation {
  KeyframeId keyframe;
  int feature = 0;
};

/// A map point. Owned by Map.
struct Landmark {
  LandmarkId id;
  Vec3d p_world = Vec3d::Zero();
  Vec3d normal = Vec3d::Zero();  ///< mean unit direction from the observing cameras to the point
  Descriptor descriptor{};       ///< of the observation closest to all others
  double min_distance = 0.0, max_distance = 0.0;  ///< where scale-space detection can find it, scene units
  std::vector<Observation> observations;          ///< at most one per keyframe
  KeyframeId first_keyframe;
  int visible_count = 1;  ///< frames that expected to see it
  int found_count = 1;    ///< frames that matched it
};

}  // namespace glide
