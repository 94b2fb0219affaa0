#include "support/small_map.h"

#include "map/map_consistency.h"
#include "map/map_header.h"
#include "map/map_io.h"
#include "map/map_records.h"
#include "map/map_restore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace glide {
namespace {

using test::partsOf;
using test::SmallMapOptions;
using test::storedSmallMap;
using testing::HasSubstr;

using Bytes = std::vector<std::byte>;
using Parts = MapSnapshot::Parts;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

SmallMapOptions withoutPatches() {
  SmallMapOptions options;
  options.has_patches = false;
  return options;
}

/// A file of the small map with its parts changed, checksum and all.
Bytes fileWith(const std::function<void(Parts*)>& change) {
  StoredMap stored = storedSmallMap({});
  Parts parts = partsOf(*stored.map);
  change(&parts);
  stored.map = std::make_shared<const MapSnapshot>(std::move(parts));
  return encodeMap(stored);
}

/// A file of the small map with a 32-bit number replaced and the checksum made right again.
Bytes fileWithNumber(MapSection section, std::size_t offset, std::uint32_t number) {
  Bytes file = encodeMap(storedSmallMap({}));
  MapHeader header;
  EXPECT_EQ(readMapHeader(file, &header), std::nullopt);
  const std::size_t at = static_cast<std::size_t>(header.offset(section)) + offset;
  for (std::size_t i = 0; i < sizeof(number); ++i) {
    file[at + i] = static_cast<std::byte>((number >> (8 * i)) & 0xFFU);
  }
  sealMapFile(file);
  return file;
}

std::string errorOf(std::span<const std::byte> file) {
  const Result<StoredMap> decoded = decodeMap(file);
  if (decoded.ok()) return "no error";
  const bool is_version = decoded.error().message.find("version") == 0;
  EXPECT_EQ(decoded.error().code,
            is_version ? ErrorCode::unknown_version : ErrorCode::invalid_data);
  return decoded.error().message;
}

/// What was accepted is a map that can be worked with, and written again as it was.
bool isSound(const Bytes& file, const StoredMap& stored) {
  Map map(stored.levels);
  restoreMap(*stored.map, &map);
  return checkConsistency(map).empty() && encodeMap(stored) == file;
}

TEST(DecodeMap, GivesBackEverything) {
  const StoredMap before = storedSmallMap({});
  const Result<StoredMap> decoded = decodeMap(encodeMap(before));
  ASSERT_TRUE(decoded.ok()) << decoded.error().message;
  const MapSnapshot& map = *decoded->map;
  EXPECT_EQ(map.revision(), before.map->revision());
  EXPECT_EQ(decoded->camera.coefficients, before.camera.coefficients);
  EXPECT_EQ(decoded->camera.fy, before.camera.fy);
  EXPECT_EQ(decoded->levels.factor(), before.levels.factor());
  ASSERT_EQ(map.keyframes().size(), before.map->keyframes().size());
  for (std::size_t i = 0; i < map.keyframes().size(); ++i) {
    const auto& a = before.map->keyframes()[i];
    const auto& b = map.keyframes()[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.t_ns, b.t_ns);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.T_cam_world.matrix(), b.T_cam_world.matrix());
    EXPECT_EQ(a.landmarks, b.landmarks);
    EXPECT_EQ(a.features->descriptors(), b.features->descriptors());
  }
  ASSERT_EQ(map.landmarks().size(), before.map->landmarks().size());
  for (std::size_t i = 0; i < map.landmarks().size(); ++i) {
    const auto& a = before.map->landmarks()[i];
    const auto& b = map.landmarks()[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.p_world, b.p_world);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.visible_count, b.visible_count);
    ASSERT_EQ(a.observations.size(), b.observations.size());
    for (std::size_t k = 0; k < a.observations.size(); ++k) {
      EXPECT_EQ(a.observations[k].keyframe, b.observations[k].keyframe);
      EXPECT_EQ(a.observations[k].feature, b.observations[k].feature);
      EXPECT_EQ(a.observations[k].level, b.observations[k].level);
    }
  }
  ASSERT_EQ(map.retired().size(), 1U);
  EXPECT_EQ(map.retired()[0].T_cam_world.matrix(), before.map->retired()[0].T_cam_world.matrix());
  ASSERT_EQ(map.loops().size(), 1U);
  EXPECT_EQ(map.loops()[0].newer, before.map->loops()[0].newer);
}

TEST(DecodeMap, KeepsThePatchesOfFeaturesThatObserveALandmark) {
  const StoredMap before = storedSmallMap({});
  const Result<StoredMap> decoded = decodeMap(encodeMap(before));
  ASSERT_TRUE(decoded.ok());
  int kept = 0, dropped = 0;
  for (std::size_t k = 0; k < before.map->keyframes().size(); ++k) {
    const auto& a = before.map->keyframes()[k];
    const auto& b = decoded->map->keyframes()[k];
    ASSERT_TRUE(b.features->hasPatches());
    for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
      const bool is_kept = a.landmarks[i] != kNoLandmark;
      const FeaturePatch blank;
      const FeaturePatch& expected = is_kept ? a.features->patch(i) : blank;
      EXPECT_EQ(b.features->patch(i).pixels, expected.pixels);
      EXPECT_EQ(b.features->patch(i).offset, expected.offset);
      ++(is_kept ? kept : dropped);
    }
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(dropped, 2);
}

TEST(DecodeMap, IsTheInverseOfEncodingByteForByte) {
  for (const SmallMapOptions& options : {SmallMapOptions{}, withoutPatches()}) {
    const Bytes file = encodeMap(storedSmallMap(options));
    const Result<StoredMap> decoded = decodeMap(file);
    ASSERT_TRUE(decoded.ok()) << decoded.error().message;
    EXPECT_TRUE(isSound(file, *decoded));
  }
}

TEST(DecodeMap, ReadsAnEmptyMap) {
  StoredMap stored = storedSmallMap({});
  stored.map = std::make_shared<const MapSnapshot>();
  const Bytes file = encodeMap(stored);
  const Result<StoredMap> decoded = decodeMap(file);
  ASSERT_TRUE(decoded.ok()) << decoded.error().message;
  EXPECT_TRUE(decoded->map->empty());
  EXPECT_TRUE(isSound(file, *decoded));
}

TEST(DecodeMap, RejectsEveryFlippedBit) {
  Bytes file = encodeMap(storedSmallMap({}));
  for (std::byte& byte : file) {
    for (int bit = 0; bit < 8; ++bit) {
      byte ^= std::byte{1} << bit;
      ASSERT_FALSE(decodeMap(file).ok()) << "byte " << &byte - file.data() << " bit " << bit;
      byte ^= std::byte{1} << bit;
    }
  }
  EXPECT_TRUE(decodeMap(file).ok());
}

TEST(DecodeMap, RejectsEveryTruncation) {
  const Bytes file = encodeMap(storedSmallMap({}));
  for (std::size_t size = 0; size < file.size(); ++size) {
    ASSERT_FALSE(decodeMap(std::span(file).first(size)).ok()) << size;
  }
  Bytes longer = file;
  longer.push_back(std::byte{0});
  EXPECT_THAT(errorOf(longer), HasSubstr("too long"));
}

TEST(DecodeMap, RejectsOrUnderstandsWhatHasTheRightChecksum) {
  Bytes file = encodeMap(storedSmallMap(withoutPatches()));
  const Bytes original = file;
  int understood = 0;
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const std::byte change : {std::byte{0x01}, std::byte{0x80}, std::byte{0xFF}}) {
      file[i] ^= change;
      sealMapFile(file);
      const Result<StoredMap> decoded = decodeMap(file);
      ASSERT_TRUE(!decoded.ok() || isSound(file, *decoded)) << "byte " << i;
      understood += decoded.ok() ? 1 : 0;
      file = original;
    }
  }
  EXPECT_GT(understood, 1000);  // a descriptor may hold any bits
}

TEST(DecodeMap, RejectsNumbersThatNoMapHas) {
  const auto keyframe = [](auto change) {
    return errorOf(fileWith([change](Parts* parts) { change(&parts->keyframes[1]); }));
  };
  EXPECT_THAT(keyframe([](auto* k) { k->T_cam_world.t.x() = kNaN; }),
              HasSubstr("keyframe 1 of the file: the position is not finite"));
  EXPECT_THAT(keyframe([](auto* k) { k->T_cam_world.t.z() = -kInfinity; }), HasSubstr("position"));
  EXPECT_THAT(keyframe([](auto* k) { k->T_cam_world.t.z() = 1e200; }), HasSubstr("position"));
  EXPECT_THAT(keyframe([](auto* k) { k->T_cam_world.q.w() *= 1.001; }), HasSubstr("quaternion"));
  EXPECT_THAT(keyframe([](auto* k) { k->T_cam_world.q.w() = kNaN; }), HasSubstr("quaternion"));
  EXPECT_THAT(keyframe([](auto* k) { k->scale = 0.0; }), HasSubstr("scale"));
  EXPECT_THAT(keyframe([](auto* k) { k->scale = kNaN; }), HasSubstr("scale"));
  const auto landmark = [](auto change) {
    return errorOf(fileWith([change](Parts* parts) { change(&parts->landmarks[2]); }));
  };
  EXPECT_THAT(landmark([](auto* l) { l->p_world.y() = kNaN; }),
              HasSubstr("landmark 2 of the file: the position is not finite"));
  EXPECT_THAT(landmark([](auto* l) { l->normal *= 1.1; }), HasSubstr("normal"));
  EXPECT_THAT(landmark([](auto* l) { l->normal.x() = kNaN; }), HasSubstr("normal"));
  EXPECT_THAT(landmark([](auto* l) { l->min_distance = l->max_distance * 2.0; }),
              HasSubstr("range of distances"));
  EXPECT_THAT(landmark([](auto* l) { l->max_distance = kInfinity; }), HasSubstr("distances"));
  EXPECT_THAT(landmark([](auto* l) { l->visible_count = -1; }), HasSubstr("count"));
  EXPECT_THAT(landmark([](auto* l) { l->first_keyframe = KeyframeId{999}; }),
              HasSubstr("first keyframe"));
}

TEST(DecodeMap, RejectsIdsThatRepeatOrDoNotAscend) {
  EXPECT_THAT(
      errorOf(fileWith([](Parts* parts) { parts->retired[0].id = parts->keyframes[0].id; })),
      HasSubstr("it is living, too"));
  // Ids are the first numbers of their records; their low halves suffice here.
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::keyframes, bytesOf<KeyframeRecord>(), 2)),
              HasSubstr("keyframe 1 of the file: the ids do not ascend"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::landmarks, bytesOf<LandmarkRecord>(), 0)),
              HasSubstr("landmark 1 of the file: the ids do not ascend"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::landmarks, 4, 0xFFFFFFFF)), HasSubstr("id"));
}

TEST(DecodeMap, RejectsIndicesOutOfRange) {
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 17, 6)),
              HasSubstr("feature 0 of the file: landmark index 6 is out of range"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::retired, bytesOf<RetiredRecord>() - 4, 3)),
              HasSubstr("parent is out of range"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::loops, 0, 3)), HasSubstr("loop 0"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::loops, 4, 0xFFFFFFFF)), HasSubstr("loop 0"));
}

TEST(DecodeMap, RejectsObservationsThatContradictEachOther) {
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 17, 1)), HasSubstr("twice"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 17, FeatureRecord::kNone)),
              HasSubstr("more patches than features"));
  EXPECT_THAT(errorOf(fileWith([](Parts* parts) {
                for (auto& keyframe : parts->keyframes) keyframe.landmarks[3] = kNoLandmark;
              })),
              HasSubstr("landmark 3 of the file: fewer than two"));
}

TEST(DecodeMap, RejectsFeaturesOutsideOfTheImageAndPatches) {
  const auto bits = [](float value) {
    std::uint32_t number = 0;
    std::memcpy(&number, &value, sizeof(number));
    return number;
  };
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 0, bits(640.0F))), HasSubstr("image"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 4, bits(-1.0F))), HasSubstr("image"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 0, 0x7FC00000)), HasSubstr("image"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::features, 8, 0x7F800000)), HasSubstr("angle"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::patches, 0, bits(9.0F))), HasSubstr("patch"));
  EXPECT_THAT(errorOf(fileWithNumber(MapSection::patches, 4, 0x7FC00000)), HasSubstr("patch"));
}

TEST(DecodeMap, RejectsAGraphThatOutgrowsTheFile) {
  // All keyframes see the one landmark there is.
  Map map(ScaleLevels(1.2, 8));
  constexpr std::uint64_t kKeyframes = 300;
  for (std::uint64_t k = 0; k < kKeyframes; ++k) {
    Keyframe keyframe;
    keyframe.id = KeyframeId{k};
    keyframe.features =
        std::make_shared<FeatureSet>(std::vector<Feature>(1), std::vector<Descriptor>(1), 640, 480);
    map.addKeyframe(std::move(keyframe));
  }
  Parts parts = partsOf(*storedSmallMap({}).map);
  parts.keyframes.clear();
  parts.retired.clear();
  parts.loops.clear();
  parts.landmarks.resize(1);
  parts.landmarks[0].first_keyframe = KeyframeId{0};
  for (const auto& [id, keyframe] : map.keyframes()) {
    parts.keyframes.push_back({id, 0, SE3d{}, 1.0, keyframe.features, {parts.landmarks[0].id}, {}});
  }
  StoredMap stored = storedSmallMap({});
  stored.map = std::make_shared<const MapSnapshot>(std::move(parts));
  EXPECT_THAT(errorOf(encodeMap(stored)), HasSubstr("implausibly many"));
}

}  // namespace
}  // namespace glide
