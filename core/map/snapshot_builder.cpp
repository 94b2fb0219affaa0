#include "map/snapshot_builder.h"

#include <utility>
#include <vector>

namespace glide {
namespace {

std::vector<MapSnapshot::KeyframeEntry> keyframeEntries(const Map& map, int min_covisibility) {
  std::vector<MapSnapshot::KeyframeEntry> entries;
  entries.reserve(map.keyframes().size());
  for (const auto& [id, keyframe] : map.keyframes()) {
    MapSnapshot::KeyframeEntry& entry = entries.emplace_back();
    entry.id = id;
    entry.t_ns = keyframe.t_ns;
    entry.T_cam_world = keyframe.T_cam_world;
    entry.scale = keyframe.scale;
    entry.features = keyframe.features;
    entry.landmarks = keyframe.landmarks;
    entry.neighbors = map.covisibility().neighbors(id, min_covisibility);
  }
  return entries;
}

std::vector<MapSnapshot::LandmarkEntry> landmarkEntries(const Map& map) {
  const std::vector<LandmarkId> ids = map.landmarkIds();
  std::vector<MapSnapshot::LandmarkEntry> entries;
  entries.reserve(ids.size());
  for (const LandmarkId id : ids) {
    const Landmark& landmark = *map.landmark(id);
    MapSnapshot::LandmarkEntry& entry = entries.emplace_back();
    entry.id = id;
    entry.p_world = landmark.p_world;
    entry.normal = landmark.normal;
    entry.min_distance = landmark.min_distance;
    entry.max_distance = landmark.max_distance;
    entry.descriptor = landmark.descriptor;
    entry.observations = landmark.observations;
    entry.first_keyframe = landmark.first_keyframe;
    entry.visible_count = landmark.visible_count;
    entry.found_count = landmark.found_count;
  }
  return entries;
}

std::vector<MapSnapshot::RetiredEntry> retiredEntries(const Map& map) {
  std::vector<MapSnapshot::RetiredEntry> entries;
  entries.reserve(map.retired().size());
  for (const auto& [id, retired] : map.retired()) {
    entries.push_back({id,
                       retired.t_ns,
                       *map.T_cam_world(id),
                       retired.scale,
                       retired.parent,
                       retired.T_cam_parent});
  }
  return entries;
}

}  // namespace

std::shared_ptr<const MapSnapshot> snapshotOf(const Map& map, const SnapshotStamp& stamp) {
  return std::make_shared<const MapSnapshot>(
      MapSnapshot::Parts{stamp.revision,
                         stamp.generation,
                         stamp.corrections,
                         keyframeEntries(map, stamp.min_covisibility),
                         landmarkEntries(map),
                         retiredEntries(map),
                         map.loops(),
                         stamp.camera});
}

}  // namespace glide
