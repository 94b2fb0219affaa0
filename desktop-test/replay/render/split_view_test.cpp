#include "replay/render/split_view.h"

#include "replay/render/plane_map.h"
#include "support/egl_context.h"

#include "glide/render_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace glide::replay {
namespace {

CameraIntrinsics bentCamera() {
  CameraIntrinsics camera = planeCamera();
  camera.distortion = DistortionModel::radial_tangential;
  camera.coefficients = {-0.25, 0.0, 0.0, 0.0, 0.0};
  return camera;
}

std::shared_ptr<const MapView> floorMap(const std::optional<CameraIntrinsics>& corrected) {
  auto map = std::make_shared<MapView>(planeMap(-Vec3d::UnitY()));
  map->corrected_camera = corrected;
  return map;
}

/// A split view in a context of its own, given frames and maps by hand.
class SplitViewTest : public testing::Test {
 protected:
  void SetUp() override {
    if (gl_.ok()) return;
    const char* required = std::getenv("GLIDE_REQUIRE_GL");
    if (required != nullptr && std::string_view(required) == "1") FAIL() << gl_.error().message;
    GTEST_SKIP() << gl_.error().message;
  }

  static SplitView makeView(RenderView view, const CameraIntrinsics& camera) {
    Result<SplitView> made = SplitView::create({camera, 0, {}, view});
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
  static void show(SplitView* view, std::shared_ptr<const MapView> map, const FrameResult& result) {
    FrameRecord record;
    record.result = result;
    SourceFrame frame;
    const CameraIntrinsics camera = planeCamera();
    frame.image = ImageU8(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
      std::fill_n(frame.image.row(y), camera.width, std::uint8_t{128});
    view->show({record, frame, std::move(map), {}});
  }
  static std::vector<std::uint8_t> drawn(SplitView* view) {
    constexpr PictureSize kSize{640, 480};
    Result<RenderTarget> target = RenderTarget::create(kSize.width, kSize.height);
    EXPECT_TRUE(target.ok() && target->begin(kPaperColor).ok());
    EXPECT_TRUE(view->draw(kSize, ViewControl()).ok());
    return target->readRgb();
  }
  /// How many pixels have a colour.
  static int colored(const std::vector<std::uint8_t>& rgb) {
    constexpr int kGreyAtMost = 40;  // between the channels of a pixel
    int count = 0;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
      const auto [least, most] = std::minmax({rgb[i], rgb[i + 1], rgb[i + 2]});
      count += most - least > kGreyAtMost ? 1 : 0;
    }
    return count;
  }

 private:
  const Result<test::EglContext> gl_ = test::EglContext::create(test::EglDebug::off);
};

TEST_F(SplitViewTest, DrawsCubesThroughTheLensThatTheMapHasCorrected) {
  SplitView given = makeView(RenderView::ar, planeCamera());
  SplitView bent = makeView(RenderView::ar, bentCamera());
  SplitView corrected = makeView(RenderView::ar, planeCamera());
  show(&given, floorMap({}), planeKeyframe());
  show(&bent, floorMap({}), planeKeyframe());
  show(&corrected, floorMap(bentCamera()), planeKeyframe());
  const std::vector<std::uint8_t> wanted = drawn(&bent);
  EXPECT_GT(colored(wanted), 100);  // a cube
  EXPECT_NE(drawn(&given), wanted);
  EXPECT_EQ(drawn(&corrected), wanted);
}

TEST_F(SplitViewTest, DrawsThroughTheGivenLensAgainWhenTheMapHasNoOther) {
  SplitView view = makeView(RenderView::ar, planeCamera());
  show(&view, floorMap({}), planeKeyframe());
  const std::vector<std::uint8_t> before = drawn(&view);
  FrameResult between = planeKeyframe();  // sets no cube down
  between.stats.keyframe = false;
  show(&view, floorMap(bentCamera()), between);
  EXPECT_NE(drawn(&view), before);
  show(&view, floorMap({}), between);
  EXPECT_EQ(drawn(&view), before);
}

TEST_F(SplitViewTest, OfTheMapAloneShowsNoPicture) {
  SplitView view = makeView(RenderView::map, planeCamera());
  show(&view, floorMap({}), planeKeyframe());
  const std::vector<std::uint8_t> rgb = drawn(&view);
  EXPECT_GT(colored(rgb), 100);  // landmarks
  const std::vector<std::uint8_t> paper(rgb.begin(), rgb.begin() + 3);
  EXPECT_GT(paper[0], 230);
}

}  // namespace
}  // namespace glide::replay
