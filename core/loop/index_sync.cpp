#include "loop/index_sync.h"

namespace glide {

void IndexSync::update(const MapSnapshot& map, PlaceIndex* index) {
  if (map.generation() != generation_) {
    index->clear();
    indexed_.clear();
    generation_ = map.generation();
  }
  for (auto it = indexed_.begin(); it != indexed_.end();) {
    if (map.keyframe(*it) != nullptr) {
      ++it;
      continue;
    }
    index->remove(*it);
    it = indexed_.erase(it);
  }
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
    if (indexed_.insert(keyframe.id).second) index->add(keyframe.id, *keyframe.features);
  }
}

}  // namespace glide
