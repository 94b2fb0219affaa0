#pragma once

#include "feature/feature_set.h"
#include "map/landmark.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <optional>

namespace glide {

/// A feature of a posed image.
struct PosedFeature {
  const FeatureSet* features = nullptr;
  int feature = 0;
  SE3d T_cam_world;
};

/// What the geometry of a refinement needs to know.
struct RefinementContext {
  const CameraModel* camera = nullptr;
  const ScaleLevels* levels = nullptr;
};

/// Moves the corner of `target` to where the patch of `source` really lies, given roughly where the
/// point is. Corners are found again with an error of most of a level pixel; aligned patches agree
/// to a tenth. Nothing when the patches do not align: the corner stays where it is.
std::optional<FeatureMove> refineFeature(const RefinementContext& context,
                                         const PosedFeature& source,
                                         const PosedFeature& target,
                                         const Vec3d& p_world);

}  // namespace glide
