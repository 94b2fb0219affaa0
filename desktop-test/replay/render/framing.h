#pragma once

#include "geometry/eigen_types.h"
#include "geometry/lie.h"

#include "glide/map_view.h"

#include <optional>
#include <vector>

namespace glide::replay {

/// What a picture of the map should show, in the map's world.
struct Framing {
  Vec3d focus = Vec3d::Zero();   ///< its middle
  Vec3d up{0.0, -1.0, 0.0};      ///< unit
  Vec3d ahead{0.0, 0.0, 1.0};    ///< unit: where the camera looks
  std::vector<Vec3d> cameras;    ///< all of them are to be seen
  std::vector<Vec3d> landmarks;  ///< most of them are to be seen
};

/// The part of the map around a camera: what lies before it, and the newest keyframes. Nothing
/// while the camera has no landmark before it.
std::optional<Framing> frameAround(const MapView& map, const SE3d& T_world_cam);

/// Where up is, as a unit vector: cameras are mostly held without roll, so that their x axes are
/// level. While they have not turned enough to tell, the middle of their upward axes decides.
Vec3d upOf(const MapView& map);

}  // namespace glide::replay
