#include "mapping/keyframe_culling.h"

#include <iterator>
#include <vector>

namespace glide {
namespace {

constexpr int kMinOtherViews = 3;  // as good as this one; enough for a well-conditioned point
constexpr std::size_t kProtectedNewest = 2;  // what tracking leans on and the mapper still extends

bool isWellSeenElsewhere(const Landmark& landmark, KeyframeId id, int level) {
  int others = 0;
  for (const Observation& observation : landmark.observations) {
    if (observation.keyframe != id && observation.level <= level) ++others;
  }
  return others >= kMinOtherViews;
}

bool isRedundant(const Map& map, const Keyframe& keyframe, double ratio) {
  int total = 0;
  int redundant = 0;
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (keyframe.landmarks[i] == kNoLandmark) continue;
    ++total;
    const Landmark& landmark = *map.landmark(keyframe.landmarks[i]);
    const int level = keyframe.features->feature(i).level;
    if (isWellSeenElsewhere(landmark, keyframe.id, level)) ++redundant;
  }
  return redundant > ratio * total;
}

bool isProtected(const Map& map, KeyframeId id) {
  const auto& keyframes = map.keyframes();
  if (keyframes.size() <= kProtectedNewest + 1 || id == keyframes.begin()->first) return true;
  const auto first_protected = std::prev(keyframes.end(), kProtectedNewest)->first;
  return !(id < first_protected);
}

}  // namespace

void cullRedundantKeyframes(MapperState* state, KeyframeId id) {
  const double ratio = state->config.mapping.redundant_ratio;
  const std::vector<CovisibleKeyframe> neighbors =
      state->map.covisibility().neighbors(id, state->config.mapping.min_covisibility);
  for (const CovisibleKeyframe& neighbor : neighbors) {
    if (isProtected(state->map, neighbor.id)) continue;
    if (!isRedundant(state->map, *state->map.keyframe(neighbor.id), ratio)) continue;
    state->map.retireKeyframe(neighbor.id);
    state->bearings.forget(neighbor.id);
  }
  state->map.refreshChanged();
}

}  // namespace glide
