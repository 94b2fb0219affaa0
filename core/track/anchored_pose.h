#pragma once

#include "map/map_snapshot.h"

#include "base/ids.h"
#include "geometry/lie.h"

#include <optional>

namespace glide {

/// A camera pose that is relative to a keyframe of the map: corrections of the map move it along
/// without a message.
struct AnchoredPose {
  KeyframeId keyframe;
  SE3d T_cam_key;
  double key_scale = 1.0;  ///< Keyframe::scale that T_cam_key is given in
  /// The keyframe's pose as known when this was made: serves where nothing below does.
  SE3d T_key_world;

  /// Where a keyframe that the mapper has not published yet hangs: what it was tracked against.
  struct Support {
    KeyframeId keyframe;
    SE3d T_key_support;
    double support_scale = 1.0;  ///< as key_scale
  };
  std::optional<Support> support;

  /// How much longer T_cam_key's translation is in `map`: other than 1 after loops.
  double growth(const MapSnapshot& map) const {
    if (const std::optional<double> scale = map.scale(keyframe)) return *scale / key_scale;
    if (!support) return 1.0;
    return map.scale(support->keyframe).value_or(support->support_scale) / support->support_scale;
  }

  /// The pose in the world of `map`.
  SE3d T_cam_world(const MapSnapshot& map) const {
    const double grown = growth(map);
    const SE3d T_cam_key_now{T_cam_key.q, grown * T_cam_key.t};
    if (const std::optional<SE3d> T = map.T_cam_world(keyframe)) return T_cam_key_now * *T;
    const std::optional<SE3d> T_support_world =
        support ? map.T_cam_world(support->keyframe) : std::nullopt;
    if (!T_support_world) return T_cam_key_now * T_key_world;
    const SE3d& T = support->T_key_support;
    return T_cam_key_now * SE3d{T.q, grown * T.t} * *T_support_world;
  }
};

/// Anchors a world pose of `map` to one of its keyframes.
inline AnchoredPose anchorTo(KeyframeId keyframe, const SE3d& T_cam_world, const MapSnapshot& map) {
  const SE3d T_key_world = map.T_cam_world(keyframe).value_or(SE3d{});
  const double scale = map.scale(keyframe).value_or(1.0);
  return {keyframe, T_cam_world * T_key_world.inverse(), scale, T_key_world, std::nullopt};
}

}  // namespace glide
