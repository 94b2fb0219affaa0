#pragma once

#include "feature/feature_set.h"

#include "base/ids.h"
#include "geometry/lie.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide {

/// A frame of the map. Its measurements are immutable and shared; pose and links are the map's.
struct Keyframe {
  KeyframeId id;
  std::int64_t t_ns = 0;
  SE3d T_cam_world;
  /// How much lengths in this keyframe's camera frame have grown by corrections of the map since it
  /// was made (loop closing); a pose measured relative to it at scale s is now longer by scale / s.
  double scale = 1.0;
  std::shared_ptr<const FeatureSet> features;
  std::vector<LandmarkId> landmarks;  ///< per feature, kNoLandmark where none
};

/// A culled keyframe: kept as a pose relative to one that lives, so that poses given relative to it
/// stay defined.
struct RetiredKeyframe {
  KeyframeId id;
  std::int64_t t_ns = 0;
  KeyframeId parent;  ///< may itself be retired later
  SE3d T_cam_parent;
  double scale = 1.0;  ///< as Keyframe::scale
};

}  // namespace glide
