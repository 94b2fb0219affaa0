#include "replay/outputs/map_glb.h"

#include "replay/outputs/run_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace glide::replay {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::FloatEq;
using ::testing::SizeIs;
using Json = nlohmann::json;

template <class T>
T read(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// A file as a viewer reads it: checks what the specification of the container demands.
struct Glb {
  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(read<std::uint32_t>(file, 4), 2U);
    EXPECT_EQ(read<std::uint32_t>(file, 8), file.size());
    for (std::size_t at = 12; at < file.size();) {
      const auto size = read<std::uint32_t>(file, at);
      EXPECT_EQ(size % 4, 0U);
      (file.substr(at + 4, 4) == "JSON" ? text : binary) = file.substr(at + 8, size);
      at += 8 + size;
    }
    json = Json::parse(text);
    if (json.contains("buffers")) {
      const std::size_t length = json["buffers"][0]["byteLength"];
      EXPECT_LE(length, binary.size());
      EXPECT_LT(binary.size(), length + 4);
    }
  }

  /// The primitives of the mesh of that name.
  Json primitives(const std::string& name) const {
    for (const Json& mesh : json.value("meshes", Json::array()))
      if (mesh["name"] == name) return mesh["primitives"];
    return Json::array();
  }

  /// An accessor's values, component by component.
  template <class T>
  std::vector<T> values(std::size_t accessor_index) const {
    const Json& accessor = json["accessors"][accessor_index];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t width = accessor["type"] == "SCALAR" ? 1U
                              : accessor["type"] == "VEC3" ? 3
                                                           : 4;
    const std::size_t count = width * accessor["count"].get<std::size_t>();
    const std::size_t offset = view["byteOffset"];
    EXPECT_EQ(offset % 4, 0U);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), count * sizeof(T));
    EXPECT_LE(offset + count * sizeof(T), binary.size());
    std::vector<T> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(read<T>(binary, offset + i * sizeof(T)));
    return result;
  }

  std::vector<float> positions(const Json& primitive) const {
    return values<float>(primitive["attributes"]["POSITION"]);
  }
  std::vector<std::uint16_t> colors(const Json& primitive) const {
    return values<std::uint16_t>(primitive["attributes"]["COLOR_0"]);
  }

  std::string text, binary;
  Json json;
};

/// Three landmarks, two keyframes at x = 0 and 4, and six frames: two direct, two indirect after a
/// frame that is lost.
class MapGlbTest : public ::testing::Test {
 protected:
  MapGlbTest() {
    for (std::uint64_t id = 1; id <= 3; ++id) {
      const auto x = static_cast<double>(id);
      fixture_.map().landmarks.push_back({id, {x, -2.0 * x, 5.0}, 2});
    }
    fixture_.addKeyframe(0, 0.0, false);
    fixture_.addKeyframe(1, 4.0, false);
    fixture_.addInitializing();
    fixture_.addTracked(TrackerKind::direct, 0);
    fixture_.addTracked(TrackerKind::direct, 0);
    fixture_.addLost();
    fixture_.addTracked(TrackerKind::indirect, 1);
    fixture_.addTracked(TrackerKind::direct, 1);
  }

  Glb glb() const {
    return Glb(mapGlb(fixture_.run, buildTrajectories(fixture_.run), PointColors()));
  }

  RunFixture fixture_;
};

TEST_F(MapGlbTest, HoldsTheLandmarksAsPointsInTheirColours) {
  const Glb file = glb();
  const Json points = file.primitives("landmarks");
  ASSERT_THAT(points, SizeIs(1));
  EXPECT_EQ(points[0]["mode"], 0);
  EXPECT_THAT(file.positions(points[0]), ElementsAre(1, -2, 5, 2, -4, 5, 3, -6, 5));
  const Json& accessor =
      file.json["accessors"][points[0]["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(accessor["min"], Json({1.0, -6.0, 5.0}));
  EXPECT_EQ(accessor["max"], Json({3.0, -2.0, 5.0}));
  const std::vector<std::uint16_t> colors = file.colors(points[0]);
  ASSERT_THAT(colors, SizeIs(12));
  EXPECT_NEAR(colors[0] / 65535.0, std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-4);
  EXPECT_EQ(colors[3], 65535);
}

TEST_F(MapGlbTest, BreaksTheTrajectoryWhereTheCameraWasLost) {
  const Glb file = glb();
  const Json strips = file.primitives("trajectory");
  ASSERT_THAT(strips, SizeIs(2));
  EXPECT_EQ(strips[0]["mode"], 3);
  EXPECT_THAT(file.positions(strips[0]), Each(FloatEq(0.0F)));
  EXPECT_THAT(file.positions(strips[1]), ElementsAre(4, 0, 0, 4, 0, 0));
  const std::vector<std::uint16_t> colors = file.colors(strips[1]);
  EXPECT_EQ(colors[0], 0);      // dark blue has no red: the indirect tracker
  EXPECT_EQ(colors[4], 65535);  // orange is full of it: the direct one
}

TEST_F(MapGlbTest, ShowsTheKeyframesAsFrusta) {
  const Glb file = glb();
  const Json frusta = file.primitives("keyframes");
  ASSERT_THAT(frusta, SizeIs(1));
  EXPECT_EQ(frusta[0]["mode"], 1);
  const std::vector<float> positions = file.positions(frusta[0]);
  ASSERT_THAT(positions, SizeIs(2U * 5U * 3U));
  EXPECT_EQ(positions[15], 4.0F);  // the eye of the second one
  EXPECT_LT(positions[3], 0.0F);   // the upper left corner of the first one
  EXPECT_LT(positions[4], 0.0F);
  EXPECT_GT(positions[5], 0.0F);
  const auto indices = file.values<std::uint32_t>(frusta[0]["indices"]);
  ASSERT_THAT(indices, SizeIs(2U * 16U));
  EXPECT_EQ(*std::max_element(indices.begin(), indices.end()), 9U);
}

TEST_F(MapGlbTest, StandsUprightInAViewer) {
  const Json json = glb().json;
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["scenes"][0]["nodes"], Json::array({0}));
  const Json& root = json["nodes"][0];
  EXPECT_EQ(root["rotation"], Json({1.0, 0.0, 0.0, 0.0}));  // y down becomes y up
  EXPECT_EQ(root["children"], Json({1, 2, 3}));
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(json["nodes"][i]["mesh"], i - 1);
}

TEST(MapGlb, OfARunWithoutAMapIsAnEmptyScene) {
  RunFixture fixture;
  fixture.addInitializing();
  const Glb file(mapGlb(fixture.run, buildTrajectories(fixture.run), PointColors()));
  for (const char* list : {"meshes", "buffers", "bufferViews", "accessors", "materials"})
    EXPECT_FALSE(file.json.contains(list)) << list;
  EXPECT_THAT(file.json["nodes"], SizeIs(1));
  EXPECT_FALSE(file.json["nodes"][0].contains("children"));
  EXPECT_TRUE(file.binary.empty());
}

}  // namespace
}  // namespace glide::replay
