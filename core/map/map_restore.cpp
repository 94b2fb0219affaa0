#include "map/map_restore.h"

#include <cassert>

namespace glide {
namespace {

Keyframe keyframeOf(const MapSnapshot::KeyframeEntry& entry) {
  Keyframe keyframe;
  keyframe.id = entry.id;
  keyframe.t_ns = entry.t_ns;
  keyframe.T_cam_world = entry.T_cam_world;
  keyframe.scale = entry.scale;
  keyframe.features = entry.features;
  return keyframe;
}

Landmark landmarkOf(const MapSnapshot::LandmarkEntry& entry) {
  Landmark landmark;
  landmark.id = entry.id;
  landmark.p_world = entry.p_world;
  landmark.normal = entry.normal;
  landmark.descriptor = entry.descriptor;
  landmark.min_distance = entry.min_distance;
  landmark.max_distance = entry.max_distance;
  landmark.observations = entry.observations;
  landmark.first_keyframe = entry.first_keyframe;
  landmark.visible_count = entry.visible_count;
  landmark.found_count = entry.found_count;
  return landmark;
}

}  // namespace

void restoreMap(const MapSnapshot& snapshot, Map* map) {
  map->clear();
  bool is_whole = true;
  for (const MapSnapshot::KeyframeEntry& entry : snapshot.keyframes()) {
    is_whole &= map->addKeyframe(keyframeOf(entry));
  }
  for (const MapSnapshot::LandmarkEntry& entry : snapshot.landmarks()) {
    is_whole &= map->restoreLandmark(landmarkOf(entry));
  }
  for (const MapSnapshot::RetiredEntry& entry : snapshot.retired()) {
    is_whole &=
        map->restoreRetired({entry.id, entry.t_ns, entry.parent, entry.T_cam_parent, entry.scale});
  }
  for (const LoopEdge& loop : snapshot.loops()) map->addLoopEdge(loop);
  assert(is_whole);
  static_cast<void>(is_whole);
}

}  // namespace glide
