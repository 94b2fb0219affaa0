#include "ar/anchors.h"

#include "geometry/pose_conversion.h"

#include <algorithm>

namespace glide {
namespace {

// Corrections below this (scene units, radians) are rounding.
constexpr double kSamePose = 1e-7;

const MapView::Keyframe* nearestKeyframe(const MapView& map, const Vec3d& p_world) {
  const auto distance = [&](const MapView::Keyframe& keyframe) {
    return (fromPose(keyframe.T_world_cam).t - p_world).squaredNorm();
  };
  const auto nearest = std::min_element(
      map.keyframes.begin(), map.keyframes.end(), [&](const auto& a, const auto& b) {
        return distance(a) < distance(b);
      });
  return nearest == map.keyframes.end() ? nullptr : &*nearest;
}

const MapView::Keyframe* findKeyframe(const MapView& map, std::uint64_t id) {
  const auto found = std::lower_bound(
      map.keyframes.begin(),
      map.keyframes.end(),
      id,
      [](const MapView::Keyframe& keyframe, std::uint64_t wanted) { return keyframe.id < wanted; });
  return found == map.keyframes.end() || found->id != id ? nullptr : &*found;
}

}  // namespace

std::optional<std::uint64_t> Anchors::create(const SE3d& T_world_anchor, const MapView& map) {
  const MapView::Keyframe* keyframe = nearestKeyframe(map, T_world_anchor.t);
  if (keyframe == nullptr) return std::nullopt;
  Anchor anchor;
  anchor.keyframe = keyframe->id;
  anchor.T_key_anchor = fromPose(keyframe->T_world_cam).inverse() * T_world_anchor;
  anchor.key_scale = keyframe->scale;
  anchor.state = {T_world_anchor, true, 0};
  anchors_.emplace(next_id_, anchor);
  return next_id_++;
}

std::optional<Anchors::State> Anchors::state(std::uint64_t id) const {
  const auto found = anchors_.find(id);
  if (found == anchors_.end()) return std::nullopt;
  return found->second.state;
}

void Anchors::follow(const MapView& map) {
  for (auto& [id, anchor] : anchors_) {
    const MapView::Keyframe* keyframe = findKeyframe(map, anchor.keyframe);
    if (!anchor.state.is_tracked) continue;
    if (keyframe == nullptr) {  // culled keyframes stay in the view: this one's map is gone
      anchor.state.is_tracked = false;
      continue;
    }
    SE3d T_key_anchor = anchor.T_key_anchor;
    T_key_anchor.t *= keyframe->scale / anchor.key_scale;
    const SE3d T_world_anchor = fromPose(keyframe->T_world_cam) * T_key_anchor;
    if ((T_world_anchor.inverse() * anchor.state.T_world_anchor).log().norm() < kSamePose) continue;
    anchor.state.T_world_anchor = T_world_anchor;
    ++anchor.state.revision;
  }
}

void Anchors::loseMap() {
  for (auto& [id, anchor] : anchors_) anchor.state.is_tracked = false;
}

}  // namespace glide
