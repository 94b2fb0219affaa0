#include "replay/outputs/point_colors.h"

#include <gtest/gtest.h>

namespace glide::replay {
namespace {

/// 4x3 pixels: gray 10 * x + y; with colour, red is that, green 100 and blue 200.
SourceFrame makeFrame(bool has_color) {
  SourceFrame frame;
  frame.image.resize(4, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) frame.image.at(x, y) = static_cast<std::uint8_t>(10 * x + y);
  if (!has_color) return frame;
  frame.color = {4, 3, {}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      for (const int value : {10 * x + y, 100, 200})
        frame.color.rgb.push_back(static_cast<std::uint8_t>(value));
  return frame;
}

TrackedPoint pointAt(std::uint64_t landmark, float u, float v) {
  return {landmark, u, v, 0.0F, true};
}

constexpr std::uint64_t kMap = 1;

TEST(PointColors, AreTheMeanOfThePixelsThatShowALandmark) {
  PointColors colors;
  const std::vector<TrackedPoint> points{pointAt(7, 1.4F, 2.0F), pointAt(7, 3.0F, 1.6F)};
  colors.add(kMap, makeFrame(true), points);
  EXPECT_EQ(colors.of(7), (Rgb8{22, 100, 200}));  // of 12 and 32
}

TEST(PointColors, AreGrayWhenTheFramesAre) {
  PointColors colors;
  const std::vector<TrackedPoint> points{pointAt(7, 2.0F, 1.0F)};
  colors.add(kMap, makeFrame(false), points);
  EXPECT_EQ(colors.of(7), (Rgb8{21, 21, 21}));
}

TEST(PointColors, IgnoreOutliersAndWhatLiesOutside) {
  PointColors colors;
  std::vector<TrackedPoint> points{
      pointAt(7, -1.0F, 1.0F), pointAt(7, 3.6F, 1.0F), pointAt(7, 1.0F, 2.6F)};
  points.push_back(pointAt(8, 1.0F, 1.0F));
  points.back().inlier = false;
  colors.add(kMap, makeFrame(true), points);
  EXPECT_EQ(colors.of(7), kUnseenColor);
  EXPECT_EQ(colors.of(8), kUnseenColor);
}

TEST(PointColors, AreForgottenWithTheFirstPointsOfAnotherMap) {
  PointColors colors;
  const std::vector<TrackedPoint> points{pointAt(7, 2.0F, 1.0F)};
  colors.add(kMap, makeFrame(true), points);
  colors.add(kMap + 1, makeFrame(true), {});  // given up: it may have been the last
  EXPECT_NE(colors.of(7), kUnseenColor);
  const std::vector<TrackedPoint> others{pointAt(8, 2.0F, 1.0F)};
  colors.add(kMap + 1, makeFrame(true), others);
  EXPECT_EQ(colors.of(7), kUnseenColor);
}

}  // namespace
}  // namespace glide::replay
