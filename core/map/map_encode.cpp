#include "map/byte_stream.h"
#include "map/map_header.h"
#include "map/map_io.h"
#include "map/map_records.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>

namespace glide {
namespace {

using Keyframes = std::vector<MapSnapshot::KeyframeEntry>;

template <class Record>
void append(Record record, std::vector<std::byte>* bytes) {
  ByteWriter writer(bytes);
  record.fields(writer);
}

std::uint32_t keyframeIndex(const Keyframes& keyframes, KeyframeId id) {
  const auto found = std::lower_bound(
      keyframes.begin(), keyframes.end(), id, [](const auto& k, KeyframeId i) { return k.id < i; });
  assert(found != keyframes.end() && found->id == id);
  return static_cast<std::uint32_t>(found - keyframes.begin());
}

bool holdsPatches(const MapSnapshot::KeyframeEntry& keyframe) {
  return keyframe.features->hasPatches();
}

/// Only features that observe a landmark keep their patch: see docs/map-format.md.
template <class Visitor>
void forEachPatch(const Keyframes& keyframes, Visitor&& visit) {
  for (const MapSnapshot::KeyframeEntry& keyframe : keyframes) {
    if (!holdsPatches(keyframe)) continue;
    for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
      if (keyframe.landmarks[i] != kNoLandmark) visit(keyframe.features->patch(i));
    }
  }
}

MapHeader headerOf(const StoredMap& stored) {
  std::size_t features = 0;
  std::size_t patches = 0;
  for (const MapSnapshot::KeyframeEntry& keyframe : stored.map->keyframes()) {
    features += keyframe.features->size();
  }
  forEachPatch(stored.map->keyframes(), [&patches](const FeaturePatch&) { ++patches; });
  MapHeader header;
  header.revision = stored.map->revision();
  header.camera = stored.camera;
  header.level_factor = stored.levels.factor();
  header.level_count = stored.levels.count();
  const std::array<std::size_t, kMapSections> counts{stored.map->keyframes().size(),
                                                     features,
                                                     patches,
                                                     stored.map->landmarks().size(),
                                                     stored.map->retired().size(),
                                                     stored.map->loops().size()};
  std::transform(counts.begin(), counts.end(), header.counts.begin(), [](std::size_t count) {
    return static_cast<std::uint32_t>(count);
  });
  return header;
}

void appendKeyframes(const Keyframes& keyframes, std::vector<std::byte>* bytes) {
  for (const MapSnapshot::KeyframeEntry& keyframe : keyframes) {
    KeyframeRecord record;
    record.id = keyframe.id.value;
    record.t_ns = keyframe.t_ns;
    record.T_cam_world = keyframe.T_cam_world;
    record.scale = keyframe.scale;
    record.features = static_cast<std::uint32_t>(keyframe.features->size());
    record.has_patches = holdsPatches(keyframe) ? 1 : 0;
    append(record, bytes);
  }
}

void appendFeatures(const MapSnapshot& map, std::vector<std::byte>* bytes) {
  std::unordered_map<LandmarkId, std::uint32_t> landmark_index{{kNoLandmark, FeatureRecord::kNone}};
  landmark_index.reserve(map.landmarks().size() + 1);
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    landmark_index.emplace(landmark.id, static_cast<std::uint32_t>(landmark_index.size() - 1));
  }
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
    for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
      FeatureRecord record;
      record.feature = keyframe.features->feature(i);
      record.landmark = landmark_index.at(keyframe.landmarks[i]);
      record.descriptor = keyframe.features->descriptor(i);
      append(record, bytes);
    }
  }
}

void appendLandmarks(const MapSnapshot& map, std::vector<std::byte>* bytes) {
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    LandmarkRecord record;
    record.id = landmark.id.value;
    record.p_world = landmark.p_world;
    record.normal = landmark.normal;
    record.min_distance = landmark.min_distance;
    record.max_distance = landmark.max_distance;
    record.descriptor = landmark.descriptor;
    record.first_keyframe = landmark.first_keyframe.value;
    record.visible_count = std::min(landmark.visible_count, LandmarkRecord::kMaxCount);
    record.found_count = std::min(landmark.found_count, LandmarkRecord::kMaxCount);
    append(record, bytes);
  }
}

void appendRetired(const MapSnapshot& map, std::vector<std::byte>* bytes) {
  for (const MapSnapshot::RetiredEntry& retired : map.retired()) {
    RetiredRecord record;
    record.id = retired.id.value;
    record.t_ns = retired.t_ns;
    record.T_cam_parent = retired.T_cam_parent;
    record.scale = retired.scale;
    record.parent = keyframeIndex(map.keyframes(), retired.parent);
    append(record, bytes);
  }
}

}  // namespace

std::vector<std::byte> encodeMap(const StoredMap& stored) {
  const MapSnapshot& map = *stored.map;
  const MapHeader header = headerOf(stored);
  std::vector<std::byte> bytes;
  bytes.reserve(static_cast<std::size_t>(header.fileBytes()));
  writeMapHeader(header, &bytes);
  appendKeyframes(map.keyframes(), &bytes);
  appendFeatures(map, &bytes);
  forEachPatch(map.keyframes(),
               [&bytes](const FeaturePatch& patch) { append(PatchRecord{patch}, &bytes); });
  appendLandmarks(map, &bytes);
  appendRetired(map, &bytes);
  for (const LoopEdge& loop : map.loops()) {
    append(LoopRecord{keyframeIndex(map.keyframes(), loop.newer),
                      keyframeIndex(map.keyframes(), loop.older)},
           &bytes);
  }
  assert(bytes.size() == header.fileBytes());
  sealMapFile(bytes);
  return bytes;
}

}  // namespace glide
