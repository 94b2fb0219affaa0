#include "replay/outputs/map_ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;

TEST(MapPly, HoldsTheLandmarksAsVertices) {
  MapView map;
  map.landmarks.push_back({7, {1.5, -2.0, 3.25}, 4});
  map.landmarks.push_back({9, {0.0, 0.5, 1e6}, 300});
  PointColors colors;
  SourceFrame frame;
  frame.image.resize(1, 1);
  frame.color = {1, 1, {65, 66, 67}};
  const std::vector<TrackedPoint> points{{7, 0.0F, 0.0F, 0.0F, true}};
  colors.add(1, frame, points);
  const std::string text = mapPly(map, colors);
  EXPECT_THAT(text, testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(text, HasSubstr("element vertex 2\nproperty float x\n"));
  EXPECT_THAT(text, HasSubstr("property uchar red\nproperty uchar green\nproperty uchar blue\n"));
  const std::string marker = "end_header\n";
  const std::size_t body = text.find(marker) + marker.size();
  constexpr std::size_t kVertexBytes = 19;
  ASSERT_EQ(text.size(), body + 2 * kVertexBytes);
  // 1.5F is 0x3FC00000 and -2.0F 0xC0000000, least significant byte first.
  EXPECT_EQ(text.substr(body, 8), std::string("\0\0\xC0\x3F\0\0\0\xC0", 8));
  EXPECT_EQ(text.substr(body + 12, 3), "ABC");
  EXPECT_EQ(text.substr(body + kVertexBytes + 12, 7), std::string("\x80\x80\x80\x2C\x01\0\0", 7));
}

TEST(MapPly, OfAnEmptyMapIsAHeader) {
  const std::string text = mapPly(MapView{}, PointColors());
  EXPECT_THAT(text, HasSubstr("element vertex 0\n"));
  EXPECT_THAT(text, testing::EndsWith("end_header\n"));
}

}  // namespace
}  // namespace glide::replay
