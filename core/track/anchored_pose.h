#pragma once

#include "map/map_snapshot.h"

#include "base/ids.h"
#include "geometry/lie.h"

namespace glide {

/// A camera pose that is relative to a keyframe of the map: corrections of the map move it along
/// without a message.
struct AnchoredPose {
  KeyframeId keyframe;
  SE3d T_cam_key;
  double key_scale = 1.0;  ///< Keyframe::scale that T_cam_key is given in
  /// The keyframe's pose as known when this was made: serves until the mapper has published it.
  SE3d T_key_world;

  /// How much longer T_cam_key's translation is in `map`: other than 1 after loops.
  double growth(const MapSnapshot& map) const {
    return map.scale(keyframe).value_or(key_scale) / key_scale;
  }

  /// The pose in the world of `map`.
  SE3d T_cam_world(const MapSnapshot& map) const {
    const SE3d T_cam_key_now{T_cam_key.q, growth(map) * T_cam_key.t};
    return T_cam_key_now * map.T_cam_world(keyframe).value_or(T_key_world);
  }
};

/// Anchors a world pose of `map` to one of its keyframes.
inline AnchoredPose anchorTo(KeyframeId keyframe, const SE3d& T_cam_world, const MapSnapshot& map) {
  const SE3d T_key_world = map.T_cam_world(keyframe).value_or(SE3d{});
  const double scale = map.scale(keyframe).value_or(1.0);
  return {keyframe, T_cam_world * T_key_world.inverse(), scale, T_key_world};
}

}  // namespace glide
