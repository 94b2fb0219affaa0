#pragma once

#include "loop/pose_suggestion.h"

#include "feature/feature_set.h"
#include "map/map_snapshot.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <optional>

namespace glide {

/// A pose of a frame in the map and all that speaks for it.
struct Placement {
  SE3d T_cam_world;
  int recognized = 0;         ///< landmarks that suggested the pose: by their looks alone
  KeyframeId reference;       ///< shares the most landmarks with the frame
  double likely = 0.0;        ///< landmarks in view, each weighted by how often tracking found it
  int matched = 0;            ///< of these, found near their projections by their looks
  int inliers = 0;            ///< of these, explained by the pose (chi2)
  int cells = 0;              ///< of Placement::kGrid x kGrid image cells, how many hold an inlier
  double median_depth = 0.0;  ///< of the inliers, scene units
  double position_sigma = 0.0;     ///< in the least certain direction, over the median depth
  static constexpr int kGrid = 6;  ///< cells along each side of the image
};

/// Widens a suggestion to all landmarks around it: looks for them where the pose projects them, far
/// off at first, and optimises the pose, twice. Nothing when the optimisation fails.
std::optional<Placement> widen(const Config& config,
                               const CameraModel& camera,
                               const MapSnapshot& map,
                               const FeatureSet& features,
                               const PoseSuggestion& suggestion);

/// Whether two placements are the same but for their errors.
bool areSame(const Placement& a, const SE3d& T_cam_world);

}  // namespace glide
