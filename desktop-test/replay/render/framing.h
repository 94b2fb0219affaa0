#pragma once

#include "geometry/eigen_types.h"
#include "geometry/lie.h"

#include "glide/map_view.h"

#include <optional>

namespace glide::replay {

/// What a picture of the map should show, in the map's world.
struct Framing {
  Vec3d focus = Vec3d::Zero();  ///< its middle
  double radius = 1.0;          ///< around the focus; in scene units
  Vec3d up{0.0, -1.0, 0.0};     ///< unit
  Vec3d ahead{0.0, 0.0, 1.0};   ///< unit: where the camera looks
};

/// The part of the map around a camera: what lies before it, and the keyframes that share landmarks
/// with the newest ones. Nothing while the camera has no landmark before it.
std::optional<Framing> frameAround(const MapView& map, const SE3d& T_world_cam);

/// The whole map: nothing when it has no landmark.
std::optional<Framing> frameAll(const MapView& map);

/// Where up is, as a unit vector: cameras are mostly held without roll, so that their x axes are
/// level. While they have not turned enough to tell, the middle of their upward axes decides.
Vec3d upOf(const MapView& map);

}  // namespace glide::replay
