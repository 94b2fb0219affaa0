#include "replay/render/split_layout.h"

#include <gtest/gtest.h>

#include <array>

namespace glide::replay {
namespace {

constexpr PictureSize kHd{1280, 720};
constexpr PictureSize kEuroc{752, 480}, kPortrait{480, 640}, kKitti{1241, 376};

std::array<Viewport, 4> partsOf(const SplitLayout& layout) {
  return {layout.picture, layout.mini_map, layout.scene, layout.timeline};
}

bool overlap(const Viewport& a, const Viewport& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(SplitLayout, KeepsItsPartsInsideAndApart) {
  for (const PictureSize& camera : {kEuroc, kPortrait, kKitti}) {
    const auto parts = partsOf(layoutOf(RenderView::split, kHd, camera));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_GT(parts[i].width, 10);
      EXPECT_GT(parts[i].height, 10);
      EXPECT_GE(parts[i].x, 0);
      EXPECT_GE(parts[i].y, 0);
      EXPECT_LE(parts[i].x + parts[i].width, kHd.width);
      EXPECT_LE(parts[i].y + parts[i].height, kHd.height);
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(parts[i], parts[j]));
    }
  }
}

TEST(SplitLayout, GivesThePictureTheCamerasShape) {
  const SplitLayout layout = layoutOf(RenderView::split, kHd, kEuroc);
  EXPECT_NEAR(layout.picture.width * 480.0 / 752.0, layout.picture.height, 1.0);
}

TEST(SplitLayout, LeavesRoomBelowATallPicture) {
  EXPECT_GT(layoutOf(RenderView::split, kHd, kPortrait).mini_map.height, kHd.height / 4);
}

TEST(SplitLayout, ShowsTheMapInTheRightHalf) {
  EXPECT_GT(layoutOf(RenderView::split, kHd, kEuroc).scene.width, kHd.width / 2);
}

TEST(SplitLayout, ShowsTheMapAloneOrTheCameraWithTheMapInACorner) {
  const SplitLayout map = layoutOf(RenderView::map, kHd, kEuroc);
  EXPECT_EQ(map.scene.width, kHd.width);
  EXPECT_TRUE(isEmpty(map.picture) && isEmpty(map.mini_map) && isEmpty(map.timeline));
  const PictureSize size = videoSize(RenderView::ar, kEuroc);
  const SplitLayout ar = layoutOf(RenderView::ar, size, kEuroc);
  EXPECT_TRUE(isEmpty(ar.scene) && isEmpty(ar.timeline));
  EXPECT_EQ(ar.picture.height, size.height);
  EXPECT_LE(ar.mini_map.x + ar.mini_map.width, size.width);
}

TEST(SplitLayout, GivesVideosOfTheCameraItsShapeAndEvenSides) {
  for (const PictureSize& camera : {kEuroc, kPortrait, kKitti}) {
    const PictureSize size = videoSize(RenderView::ar, camera);
    EXPECT_EQ(size.width % 2, 0);
    EXPECT_EQ(size.height % 2, 0);
    EXPECT_NEAR(static_cast<double>(size.height) / size.width,
                static_cast<double>(camera.height) / camera.width,
                0.01);
  }
}

}  // namespace
}  // namespace glide::replay
