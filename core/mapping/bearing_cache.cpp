#include "mapping/bearing_cache.h"

namespace glide {

const std::vector<Vec3d>& BearingCache::of(const Keyframe& keyframe) {
  const auto [place, is_new] = bearings_.try_emplace(keyframe.id);
  std::vector<Vec3d>& bearings = place->second;
  if (!is_new) return bearings;
  bearings.reserve(keyframe.features->size());
  for (const Feature& feature : keyframe.features->features()) {
    bearings.push_back(camera_.unproject(feature.uv.cast<double>()).value_or(Vec3d::Zero()));
  }
  return bearings;
}

}  // namespace glide
