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

}  // namespace

std::optional<std::uint64_t> Anchors::create(const SE3d& T_world_anchor, const MapView& map) {
  const MapView::Keyframe* keyframe = nearestKeyframe(map, T_world_anchor.t);
  if (keyframe == nullptr) return std::nullopt;
  follow(map);
  Anchor anchor;
  anchor.generation = map.generation;
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
  if (map.generation == followed_generation_ && map.revision == followed_revision_) return;
  followed_generation_ = map.generation;
  followed_revision_ = map.revision;
  for (auto& [id, anchor] : anchors_) {
    anchor.state.is_tracked = anchor.state.is_tracked && anchor.generation == map.generation;
    if (anchor.state.is_tracked) follow(map, &anchor);
  }
}

void Anchors::follow(const MapView& map, Anchor* anchor) {
  const MapView::Keyframe* keyframe = map.keyframe(anchor->keyframe);
  anchor->state.is_tracked = keyframe != nullptr;  // culled ones stay in the view
  if (keyframe == nullptr) return;
  SE3d T_key_anchor = anchor->T_key_anchor;
  T_key_anchor.t *= keyframe->scale / anchor->key_scale;
  const SE3d T_world_anchor = fromPose(keyframe->T_world_cam) * T_key_anchor;
  State* state = &anchor->state;
  if ((T_world_anchor.inverse() * state->T_world_anchor).log().norm() < kSamePose) return;
  state->T_world_anchor = T_world_anchor;
  ++state->revision;
}

}  // namespace glide
