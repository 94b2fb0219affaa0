#include "map/byte_stream.h"
#include "map/map_header.h"
#include "map/map_io.h"
#include "map/map_records.h"
#include "map/record_checks.h"

#include <algorithm>
#include <string>
#include <utility>

namespace glide {
namespace {

/// A file whose header was found to be right, so that every section lies inside of it, and what was
/// read of it so far.
struct Decoding {
  MapHeader header;
  std::vector<KeyframeRecord> keyframes;
  MapSnapshot::Parts parts;
};

using File = std::span<const std::byte>;

ByteReader sectionOf(File file, const MapHeader& header, MapSection section) {
  return ByteReader(file.subspan(static_cast<std::size_t>(header.offset(section))));
}

template <class Record>
Record read(ByteReader* reader) {
  Record record;
  record.fields(*reader);
  return record;
}

MapFault fault(const char* kind, std::size_t index, const std::string& what) {
  return std::string(kind) + " " + std::to_string(index) + " of the file: " + what;
}

template <class Entry>
bool hasId(const std::vector<Entry>& ascending, KeyframeId id) {
  const auto found =
      std::lower_bound(ascending.begin(), ascending.end(), id, [](const Entry& e, KeyframeId i) {
        return e.id < i;
      });
  return found != ascending.end() && found->id == id;
}

/// Whether an entry with this id may follow.
template <class Entry, class EntryId>
bool ascends(const std::vector<Entry>& entries, EntryId id) {
  return entries.empty() || entries.back().id < id;
}

MapFault readKeyframes(File file, Decoding* decoding) {
  const std::uint32_t count = decoding->header.count(MapSection::keyframes);
  ByteReader reader = sectionOf(file, decoding->header, MapSection::keyframes);
  decoding->keyframes.reserve(count);
  decoding->parts.keyframes.reserve(count);
  std::uint64_t features = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto record = read<KeyframeRecord>(&reader);
    if (MapFault wrong = checkKeyframe(record)) return fault("keyframe", i, *wrong);
    if (!ascends(decoding->parts.keyframes, KeyframeId{record.id})) {
      return fault("keyframe", i, "the ids do not ascend");
    }
    MapSnapshot::KeyframeEntry& entry = decoding->parts.keyframes.emplace_back();
    entry.id = KeyframeId{record.id};
    entry.t_ns = record.t_ns;
    entry.T_cam_world = record.T_cam_world;
    entry.scale = record.scale;
    decoding->keyframes.push_back(record);
    features += record.features;
  }
  if (features == decoding->header.count(MapSection::features)) return std::nullopt;
  return "the keyframes have " + std::to_string(features) + " features, the header tells of " +
         std::to_string(decoding->header.count(MapSection::features));
}

MapFault readRetired(File file, Decoding* decoding) {
  const std::uint32_t count = decoding->header.count(MapSection::retired);
  ByteReader reader = sectionOf(file, decoding->header, MapSection::retired);
  MapSnapshot::Parts& parts = decoding->parts;
  parts.retired.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto record = read<RetiredRecord>(&reader);
    if (MapFault wrong = checkRetired(record)) return fault("retired keyframe", i, *wrong);
    const KeyframeId id{record.id};
    if (!ascends(parts.retired, id)) return fault("retired keyframe", i, "the ids do not ascend");
    if (hasId(parts.keyframes, id)) return fault("retired keyframe", i, "it is living, too");
    if (record.parent >= parts.keyframes.size()) {
      return fault("retired keyframe", i, "the index of its parent is out of range");
    }
    const MapSnapshot::KeyframeEntry& parent = parts.keyframes[record.parent];
    parts.retired.push_back({id,
                             record.t_ns,
                             record.T_cam_parent * parent.T_cam_world,
                             record.scale,
                             parent.id,
                             record.T_cam_parent});
  }
  return std::nullopt;
}

MapFault readLoops(File file, Decoding* decoding) {
  const std::uint32_t count = decoding->header.count(MapSection::loops);
  ByteReader reader = sectionOf(file, decoding->header, MapSection::loops);
  MapSnapshot::Parts& parts = decoding->parts;
  parts.loops.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto record = read<LoopRecord>(&reader);
    if (std::max(record.newer, record.older) >= parts.keyframes.size()) {
      return fault("loop", i, "the index of a keyframe is out of range");
    }
    parts.loops.push_back({parts.keyframes[record.newer].id, parts.keyframes[record.older].id});
  }
  return std::nullopt;
}

MapFault readLandmarks(File file, Decoding* decoding) {
  const std::uint32_t count = decoding->header.count(MapSection::landmarks);
  ByteReader reader = sectionOf(file, decoding->header, MapSection::landmarks);
  MapSnapshot::Parts& parts = decoding->parts;
  parts.landmarks.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto record = read<LandmarkRecord>(&reader);
    if (MapFault wrong = checkLandmark(record)) return fault("landmark", i, *wrong);
    const LandmarkId id{record.id};
    if (!ascends(parts.landmarks, id)) return fault("landmark", i, "the ids do not ascend");
    const KeyframeId first{record.first_keyframe};
    if (!hasId(parts.keyframes, first) && !hasId(parts.retired, first)) {
      return fault("landmark", i, "its first keyframe is not in the file");
    }
    MapSnapshot::LandmarkEntry& entry = parts.landmarks.emplace_back();
    entry.id = id;
    entry.p_world = record.p_world;
    entry.normal = record.normal;
    entry.min_distance = record.min_distance;
    entry.max_distance = record.max_distance;
    entry.descriptor = record.descriptor;
    entry.first_keyframe = first;
    entry.visible_count = record.visible_count;
    entry.found_count = record.found_count;
  }
  return std::nullopt;
}

/// Positions in the sections that hold the features of all keyframes, one after the other.
struct FeatureReaders {
  ByteReader features, patches;
  std::uint32_t features_read = 0, patches_read = 0;
};

MapFault observe(MapSnapshot::LandmarkEntry* landmark, const Observation& observation) {
  std::vector<Observation>& seen = landmark->observations;
  if (!seen.empty() && seen.back().keyframe == observation.keyframe) {
    return "its keyframe sees the landmark twice";
  }
  seen.push_back(observation);
  return std::nullopt;
}

MapFault readPatch(FeatureReaders* readers, const MapHeader& header, FeaturePatch* patch) {
  if (readers->patches_read == header.count(MapSection::patches)) return "its patch is missing";
  const auto record = read<PatchRecord>(&readers->patches);
  ++readers->patches_read;
  *patch = record.patch;
  return checkPatch(record);
}

MapFault readFeatureSet(const KeyframeRecord& record,
                        FeatureReaders* readers,
                        Decoding* decoding,
                        MapSnapshot::KeyframeEntry* keyframe) {
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
  std::vector<FeaturePatch> patches(record.has_patches == 1 ? record.features : 0);
  features.reserve(record.features);
  descriptors.reserve(record.features);
  keyframe->landmarks.assign(record.features, kNoLandmark);
  for (std::uint32_t i = 0; i < record.features; ++i) {
    const auto feature = read<FeatureRecord>(&readers->features);
    const std::uint32_t index = readers->features_read++;
    if (MapFault wrong = checkFeature(feature, decoding->header)) {
      return fault("feature", index, *wrong);
    }
    features.push_back(feature.feature);
    descriptors.push_back(feature.descriptor);
    if (feature.landmark == FeatureRecord::kNone) continue;
    MapSnapshot::LandmarkEntry* landmark = &decoding->parts.landmarks[feature.landmark];
    keyframe->landmarks[i] = landmark->id;
    const Observation seen{keyframe->id, static_cast<int>(i), feature.feature.level};
    if (MapFault wrong = observe(landmark, seen)) return fault("feature", index, *wrong);
    if (patches.empty()) continue;
    if (MapFault wrong = readPatch(readers, decoding->header, &patches[i])) {
      return fault("feature", index, *wrong);
    }
  }
  const CameraIntrinsics& camera = decoding->header.camera;
  FeatureSet set(std::move(features), std::move(descriptors), camera.width, camera.height);
  if (!patches.empty()) set = std::move(set).withPatches(std::move(patches));
  keyframe->features = std::make_shared<const FeatureSet>(std::move(set));
  return std::nullopt;
}

MapFault readFeatures(File file, Decoding* decoding) {
  FeatureReaders readers{sectionOf(file, decoding->header, MapSection::features),
                         sectionOf(file, decoding->header, MapSection::patches)};
  for (std::size_t i = 0; i < decoding->keyframes.size(); ++i) {
    MapSnapshot::KeyframeEntry* keyframe = &decoding->parts.keyframes[i];
    if (MapFault wrong = readFeatureSet(decoding->keyframes[i], &readers, decoding, keyframe)) {
      return wrong;
    }
  }
  if (readers.patches_read == decoding->header.count(MapSection::patches)) return std::nullopt;
  return "there are more patches than features that observe a landmark";
}

/// One view does not locate a point. And the covisibility that follows from the observations, which
/// is quadratic in them, must not outgrow the file: real maps stay below a hundredth of it.
MapFault checkObservations(const MapSnapshot::Parts& parts, std::uint64_t file_bytes) {
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < parts.landmarks.size(); ++i) {
    const std::uint64_t views = parts.landmarks[i].observations.size();
    if (views < 2) return fault("landmark", i, "fewer than two features observe it");
    pairs += views * views;
  }
  if (pairs <= file_bytes) return std::nullopt;
  return "implausibly many keyframes see the same landmarks";
}

MapFault readSections(File file, Decoding* decoding) {
  decoding->parts.revision = decoding->header.revision;
  if (MapFault wrong = readKeyframes(file, decoding)) return wrong;
  if (MapFault wrong = readRetired(file, decoding)) return wrong;
  if (MapFault wrong = readLoops(file, decoding)) return wrong;
  if (MapFault wrong = readLandmarks(file, decoding)) return wrong;
  if (MapFault wrong = readFeatures(file, decoding)) return wrong;
  return checkObservations(decoding->parts, file.size());
}

}  // namespace

Result<StoredMap> decodeMap(std::span<const std::byte> bytes) {
  Decoding decoding;
  MapFault wrong = readMapHeader(bytes, &decoding.header);
  if (!wrong) wrong = readSections(bytes, &decoding);
  const bool is_other = isOtherMapVersion(bytes);
  if (wrong) {
    return Error{is_other ? ErrorCode::unknown_version : ErrorCode::invalid_data,
                 *std::move(wrong)};
  }
  const MapHeader& header = decoding.header;
  decoding.parts.camera = std::make_shared<const CameraModel>(*CameraModel::create(header.camera));
  return StoredMap{std::make_shared<const MapSnapshot>(std::move(decoding.parts)),
                   header.camera,
                   ScaleLevels(header.level_factor, header.level_count)};
}

}  // namespace glide
