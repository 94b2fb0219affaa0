#include "render/camera_layout.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

void expectArea(const Viewport& area, const Viewport& expected) {
  EXPECT_EQ(area.x, expected.x);
  EXPECT_EQ(area.y, expected.y);
  EXPECT_EQ(area.width, expected.width);
  EXPECT_EQ(area.height, expected.height);
}

TEST(PictureLayout, FillsAViewportOfItsAspectRatio) {
  expectArea(PictureLayout::fit({320, 240}, {0, 0, 320, 240}).area, {0, 0, 320, 240});
  expectArea(PictureLayout::fit({320, 240}, {10, 20, 640, 480}).area, {10, 20, 640, 480});
}

TEST(PictureLayout, LeavesBarsAboveOrBeside) {
  expectArea(PictureLayout::fit({320, 240}, {0, 0, 320, 400}).area, {0, 80, 320, 240});
  expectArea(PictureLayout::fit({320, 240}, {5, 7, 500, 240}).area, {95, 7, 320, 240});
}

TEST(PictureLayout, KeepsAtLeastAPixel) {
  expectArea(PictureLayout::fit({1000, 1}, {0, 0, 10, 10}).area, {0, 4, 10, 1});
}

TEST(PictureLayout, PlacesPixelsByTheirCentres) {
  const PictureLayout layout = PictureLayout::fit({320, 240}, {100, 50, 640, 480});
  const PointPx first = layout.place({0.0, 0.0}, {320, 240});
  EXPECT_FLOAT_EQ(first[0], 1.0F);
  EXPECT_FLOAT_EQ(first[1], 1.0F);
  const PointPx last = layout.place({319.0, 239.0}, {320, 240});
  EXPECT_FLOAT_EQ(last[0], 639.0F);
  EXPECT_FLOAT_EQ(last[1], 479.0F);
}

}  // namespace
}  // namespace glide::test
