// How maps look.
#include "render/map_fixture.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr Viewport kWhole{0, 0, 320, 240};
constexpr Viewport kInset{212, 8, 100, 100};

class MapGolden : public MapRendererTest {
 protected:
  /// The room is larger than what sessions begin with.
  static MapStyle largeFrusta() {
    MapStyle style;
    style.frustum_size = 0.15F;
    return style;
  }
  /// What `draw` leaves on paper.
  template <class Draw>
  static RgbPicture onPaper(const Draw& draw) {
    Result<RenderTarget> target = RenderTarget::create(kWhole.width, kWhole.height);
    EXPECT_TRUE(target.ok()) << target.error().message;
    EXPECT_TRUE(target->begin(kPaper).ok());
    EXPECT_TRUE(draw().ok());
    return {kWhole.width, kWhole.height, target->readRgb()};
  }
  void expectGolden(const RgbPicture& picture, const std::string& name) const {
    if (!hasGoldens()) return;
    EXPECT_TRUE(looksAsGolden(picture, name));
  }
};

TEST_F(MapGolden, ARoomThatWasWalkedAround) {
  MapRenderer renderer = rendererOf(makeRoomMap({1200, 18, 180}));
  renderer.setStyle(largeFrusta());
  expectGolden(onPaper([&] { return renderer.draw(cornerView(kWhole), kWhole); }), "map_room");
}

TEST_F(MapGolden, EveryFrameTheTruthAndLandmarksByAge) {
  const RoomMap room = makeRoomMap({600, 12, 60});
  MapRenderer renderer = rendererOf(room);
  renderer.setTruth(room.truth);
  MapStyle style = largeFrusta();
  style.coloring = LandmarkColoring::recency;
  style.frame_frusta = true;
  style.covisibility = false;
  style.line_px = 2.5F;
  renderer.setStyle(style);
  const ViewCamera above = viewFrom({0.3F, -3.2F, -0.6F}, {0.0F, 0.0F, 1.3F}, kWhole);
  expectGolden(onPaper([&] { return renderer.draw(above, kWhole); }), "map_frames");
}

TEST_F(MapGolden, FromAboveInAnInset) {
  MapRenderer renderer = rendererOf(makeRoomMap({900, 16, 100}));
  const RgbPicture picture = onPaper([&] {
    EXPECT_TRUE(renderer.draw(cornerView(kWhole), kWhole).ok());
    return renderer.drawMiniMap(kInset);
  });
  expectGolden(picture, "map_inset");
}

TEST_F(MapGolden, FromWithinWithLinesThatComeFromBehind) {
  MapRenderer renderer = rendererOf(makeRoomMap({1000, 18, 180}));
  renderer.setStyle(largeFrusta());
  // On the way itself: half of it is behind the eye.
  const ViewCamera within = viewFrom({0.9F, 0.1F, 0.35F}, {-0.4F, 0.2F, 2.2F}, kWhole);
  expectGolden(onPaper([&] { return renderer.draw(within, kWhole); }), "map_within");
}

}  // namespace
}  // namespace glide::test
