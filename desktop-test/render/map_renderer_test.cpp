#include "glide/map_renderer.h"

#include "render/map_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 200, kHeight = 150;
constexpr Viewport kWhole{0, 0, kWidth, kHeight};
constexpr Color kBlack{0.0F, 0.0F, 0.0F, 1.0F};

class MapRendererDrawTest : public MapRendererTest {
 protected:
  void SetUp() override {
    MapRendererTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    Result<RenderTarget> target = RenderTarget::create(kWidth, kHeight);
    ASSERT_TRUE(target.ok()) << target.error().message;
    target_.emplace(std::move(*target));
  }
  void TearDown() override {
    target_.reset();
    MapRendererTest::TearDown();
  }
  RgbPicture picture(MapRenderer* renderer, const ViewCamera& view) {
    target_->begin(kBlack);
    const Status drawn = renderer->draw(view, kWhole);
    EXPECT_TRUE(drawn.ok()) << drawn.error().message;
    return {kWidth, kHeight, target_->readRgb()};
  }
  RenderTarget& target() { return *target_; }

 private:
  std::optional<RenderTarget> target_;
};

/// One landmark in front of the origin and nothing else.
std::shared_ptr<const MapView> oneLandmark(double x, double y, double z) {
  auto map = std::make_shared<MapView>();
  map->landmarks.push_back({1, {x, y, z}, 20});
  return map;
}

FrameResult trackedAt(double x, double z, TrackerKind tracker) {
  FrameResult frame;
  frame.state = TrackingState::tracking;
  frame.tracker = tracker;
  frame.T_world_cam.t_xyz = {x, 0.0, z};
  return frame;
}

TEST_F(MapRendererDrawTest, TakesLessThanTenDrawCallsForALargeMap) {
  const RoomMapSize size = isSlow() ? RoomMapSize{2000, 20, 200} : RoomMapSize{20'000, 200, 2000};
  const RoomMap room = makeRoomMap(size);
  MapRenderer renderer = rendererOf(room);
  renderer.setTruth(room.truth);
  MapStyle everything;
  everything.frame_frusta = true;
  renderer.setStyle(everything);
  picture(&renderer, cornerView(kWhole));
  EXPECT_GT(renderer.drawCalls(), 5);
  EXPECT_LT(renderer.drawCalls(), 10);
  EXPECT_TRUE(renderer.drawMiniMap(kWhole).ok());
  EXPECT_LT(renderer.drawCalls(), 10);
}

TEST_F(MapRendererDrawTest, DrawsNothingOfAnEmptyMap) {
  MapRenderer renderer = makeRenderer();
  const RgbPicture empty = picture(&renderer, cornerView(kWhole));
  EXPECT_EQ(renderer.drawCalls(), 0);
  EXPECT_EQ(countOf(empty, kBlack, 0), kWidth * kHeight);
  EXPECT_TRUE(renderer.drawMiniMap(kWhole).ok());
}

TEST_F(MapRendererDrawTest, PutsALandmarkWhereTheCameraSeesIt) {
  MapRenderer renderer = makeRenderer();
  MapStyle style;
  style.landmark_px = 8.0F;
  renderer.setStyle(style);
  // y points down, x to the right, z forward.
  renderer.setMap(oneLandmark(0.5, 0.4, 2.0));
  const ViewCamera view = viewFrom({0, 0, 0}, {0, 0, 1}, kWhole);
  const RgbPicture seen = picture(&renderer, view);
  const float focal_px = 0.5F * kHeight * view.projection[5];
  const auto x = static_cast<int>(0.5F * kWidth + focal_px * 0.25F);
  const auto y = static_cast<int>(0.5F * kHeight + focal_px * 0.2F);
  EXPECT_NE(pixelAt(seen, x, y), (std::array<int, 3>{0, 0, 0}));
  EXPECT_GT(countOf(seen, kBlack, 0), kWidth * kHeight - 150);
}

TEST_F(MapRendererDrawTest, HidesWhatIsBehind) {
  MapRenderer renderer = makeRenderer();
  MapStyle style;
  style.landmark_px = 40.0F;
  style.coloring = LandmarkColoring::recency;  // the first is gray, the last green
  renderer.setStyle(style);
  auto map = std::make_shared<MapView>();
  map->landmarks.push_back({1, {0.0, 0.0, 2.0}, 20});
  for (std::uint64_t id = 2; id < 5; ++id) map->landmarks.push_back({id, {0.0, 0.0, 4.0}, 20});
  renderer.setMap(map);
  const std::array<int, 3> center =
      pixelAt(picture(&renderer, viewFrom({0, 0, 0}, {0, 0, 1}, kWhole)), kWidth / 2, kHeight / 2);
  EXPECT_NEAR(center[0], center[1], 10);
}

TEST_F(MapRendererDrawTest, ColoursTheWayByTracker) {
  MapRenderer renderer = makeRenderer();
  MapStyle style;
  style.line_px = 6.0F;
  renderer.setStyle(style);
  renderer.setMap(oneLandmark(0.0, 0.3, 2.0));  // tells the depth cue where the scene is
  const ViewCamera view = viewFrom({0, 0, 0}, {0, 0, 1}, kWhole);
  for (const double x : {-0.9, -0.3}) renderer.addFrame(trackedAt(x, 2.0, TrackerKind::direct));
  for (const double x : {0.3, 0.9}) renderer.addFrame(trackedAt(x, 2.0, TrackerKind::indirect));
  const RgbPicture seen = picture(&renderer, view);
  EXPECT_GT(countOf(seen, kDirectColor, 60), 80);
  EXPECT_GT(countOf(seen, kIndirectColor, 60), 80);
  style.trajectory = false;
  renderer.setStyle(style);
  EXPECT_LT(countOf(picture(&renderer, view), kDirectColor, 60), 20);
}

TEST_F(MapRendererDrawTest, DrawsLinesAsWideAsTheyShallBe) {
  MapRenderer renderer = makeRenderer();
  MapStyle style;
  style.line_px = 9.0F;
  renderer.setStyle(style);
  const std::vector<Pose> truth{{{-5.0, 0.0, 2.0}}, {{5.0, 0.0, 2.0}}};
  renderer.setTruth(truth);
  const RgbPicture seen = picture(&renderer, viewFrom({0, 0, 0}, {0, 0, 1}, kWhole));
  int lit = 0;
  for (int y = 0; y < kHeight; ++y) lit += pixelAt(seen, kWidth / 2, y)[1] > 40 ? 1 : 0;
  EXPECT_NEAR(lit, 9, 1);
}

TEST_F(MapRendererDrawTest, DrawsALineThatBeginsBehindTheEye) {
  MapRenderer renderer = makeRenderer();
  const std::vector<Pose> truth{{{0.2, 0.3, -5.0}}, {{0.0, 0.3, 3.0}}};
  renderer.setTruth(truth);
  const RgbPicture seen = picture(&renderer, viewFrom({0, 0, 0}, {0, 0, 1}, kWhole));
  EXPECT_GT(countOf(seen, kTruthColor, 60), 20);
  for (int x = 0; x < kWidth; ++x)
    EXPECT_EQ(pixelAt(seen, x, kHeight / 2 - 5), (std::array<int, 3>{0, 0, 0})) << "above the line";
}

TEST_F(MapRendererDrawTest, TouchesNothingOutsideOfTheViewport) {
  MapRenderer renderer = rendererOf(makeRoomMap({}));
  MapStyle thick;
  thick.line_px = 20.0F;
  thick.landmark_px = 30.0F;
  renderer.setStyle(thick);
  constexpr Viewport kPart{40, 30, 100, 80};
  target().begin(kBlack);
  EXPECT_TRUE(renderer.draw(cornerView(kPart), kPart).ok());
  EXPECT_TRUE(renderer.drawMiniMap(kPart).ok());
  const RgbPicture seen{kWidth, kHeight, target().readRgb()};
  int outside = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int x = i % kWidth;
    const int y = kHeight - 1 - i / kWidth;  // viewports count from below
    const bool is_inside = x >= 40 && x < 140 && y >= 30 && y < 110;
    if (!is_inside && pixelAt(seen, x, i / kWidth) != std::array<int, 3>{0, 0, 0}) ++outside;
  }
  EXPECT_EQ(outside, 0);
  EXPECT_LT(countOf(seen, kBlack, 0), kWidth * kHeight - 4000);
}

TEST_F(MapRendererDrawTest, RefusesAnEmptyViewport) {
  MapRenderer renderer = makeRenderer();
  for (const Viewport& viewport : {Viewport{0, 0, 0, 10}, Viewport{0, 0, 10, -1}}) {
    const Status refused = renderer.drawMiniMap(viewport);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(refused.error().message, HasSubstr("viewport"));
  }
}

TEST_F(MapRendererDrawTest, RefusesAFramebufferThatCannotBeDrawnTo) {
  MapRenderer renderer = makeRenderer();
  GLuint empty = 0;
  glGenFramebuffers(1, &empty);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, empty);
  const Status refused = renderer.draw(cornerView(kWhole), kWhole);
  glDeleteFramebuffers(1, &empty);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message, HasSubstr("framebuffer"));
}

TEST_F(MapRendererDrawTest, DrawsTheSameAfterItsObjectsWereReleased) {
  MapRenderer renderer = rendererOf(makeRoomMap({500, 8, 40}));
  const ViewCamera view = cornerView(kWhole);
  const RgbPicture before = picture(&renderer, view);
  renderer.releaseGl();
  EXPECT_EQ(picture(&renderer, view).pixels, before.pixels);
}

TEST_F(MapRendererDrawTest, DrawsAPathThatGrewAsIfItHadBeenThereAtOnce) {
  const RoomMap room = makeRoomMap({300, 6, 300});
  MapRenderer grown = makeRenderer();
  grown.setMap(room.map);
  const ViewCamera view = cornerView(kWhole);
  for (std::size_t i = 0; i < room.frames.size(); ++i) {
    grown.addFrame(room.frames[i]);
    if (i % 60 == 0) picture(&grown, view);
  }
  MapRenderer whole = rendererOf(room);
  EXPECT_EQ(picture(&grown, view).pixels, picture(&whole, view).pixels);
}

}  // namespace
}  // namespace glide::test
