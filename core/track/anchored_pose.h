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
  /// The keyframe's pose as known when this was made: serves until the mapper has published it.
  SE3d T_key_world;

  /// The pose in the world of `map`.
  SE3d T_cam_world(const MapSnapshot& map) const {
    return T_cam_key * map.T_cam_world(keyframe).value_or(T_key_world);
  }
};

/// Anchors a world pose of `map` to one of its keyframes.
inline AnchoredPose anchorTo(KeyframeId keyframe, const SE3d& T_cam_world, const MapSnapshot& map) {
  const SE3d T_key_world = map.T_cam_world(keyframe).value_or(SE3d{});
  return {keyframe, T_cam_world * T_key_world.inverse(), T_key_world};
}

}  // namespace glide
