#include "mapping/witnesses.h"

#include "feature/feature_set.h"

#include <algorithm>
#include <optional>

namespace glide {
namespace {

// Poses and the point are not adjusted yet: px of the finest level.
constexpr float kRadiusPx = 4.0F;
// From another side a patch looks different: looser than the match that made the point.
constexpr int kMaxDescriptorDistance = 64;
// Detection finds corners near the border in some views only.
constexpr double kBorderPx = 20.0;

}  // namespace

Witnesses::Witnesses(const MapperState& state, const Keyframe& a, const Keyframe& b)
    : state_(state), a_(a) {
  const KeyframeId first = std::min(a.id, b.id), last = std::max(a.id, b.id);
  const int min_weight = state.config.mapping.min_covisibility;
  for (const CovisibleKeyframe& neighbor : state.map.covisibility().neighbors(a.id, min_weight)) {
    if (first < neighbor.id && neighbor.id < last)
      between_.push_back(state.map.keyframe(neighbor.id));
  }
}

bool Witnesses::agree(const Vec3d& p_world, int feature) const {
  const Descriptor& descriptor = a_.features->descriptor(static_cast<std::size_t>(feature));
  int asked = 0, seen = 0;
  for (const Keyframe* witness : between_) {
    const std::optional<Vec2d> uv = state_.camera.project(witness->T_cam_world * p_world);
    if (!uv || !state_.camera.isInImage(*uv, kBorderPx)) continue;
    ++asked;
    seen += sees(*witness, p_world, descriptor) ? 1 : 0;
  }
  return 2 * seen >= asked;
}

bool Witnesses::sees(const Keyframe& witness,
                     const Vec3d& p_world,
                     const Descriptor& descriptor) const {
  const std::optional<Vec2d> uv = state_.camera.project(witness.T_cam_world * p_world);
  std::vector<int> found;
  witness.features->query({uv->cast<float>(), kRadiusPx}, &found);
  return std::any_of(found.begin(), found.end(), [&](int i) {
    const Descriptor& other = witness.features->descriptor(static_cast<std::size_t>(i));
    return descriptorDistance(descriptor, other) <= kMaxDescriptorDistance;
  });
}

}  // namespace glide
