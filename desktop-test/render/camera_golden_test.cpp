// How the camera's picture, points and AR content look.
#include "render/camera_scene.h"

#include "gpu/gl_test.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

class CameraGolden : public GlTest {
 protected:
  static CameraRenderer makeRenderer(const CameraIntrinsics& camera) {
    Result<CameraRenderer> made = CameraRenderer::create(GlStatePolicy::preserve, camera);
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }

  /// Axes and three cubes on the tiles.
  static RgbPicture arView(const CameraIntrinsics& camera, const Pose& T_world_cam) {
    CameraRenderer renderer = makeRenderer(camera);
    const GreyPicture floor = tiledFloor(camera, T_world_cam);
    const std::vector<Pose> cubes{{{0.22, 0.0, 0.1}}, {{-0.16, 0.0, 0.3}}, {{0.2, 0.0, -0.17}}};
    ArContent content;
    content.cubes = cubes;
    content.cube_edge = 0.12F;
    return drawn(camera.width, camera.height, [&](const Viewport& viewport) {
      EXPECT_TRUE(renderer.drawPicture(floor.luma(), viewport).ok());
      EXPECT_TRUE(renderer.drawAr(content, T_world_cam, viewport).ok());
    });
  }
};

TEST_F(CameraGolden, AxesAndCubesStandOnTheGround) {
  const CameraIntrinsics camera = pinhole(320, 240);
  EXPECT_TRUE(
      looksAsGolden(arView(camera, lookAt({0.25, -0.4, -0.6}, {0.05, 0.0, 0.05})), "camera_ar"));
}

TEST_F(CameraGolden, ThroughAFisheyeTheyBendAsThePictureDoes) {
  const CameraIntrinsics camera = fisheye(320, 240);
  EXPECT_TRUE(looksAsGolden(arView(camera, lookAt({0.1, -0.16, -0.3}, {0.05, 0.0, 0.05})),
                            "camera_ar_fisheye"));
}

TEST_F(CameraGolden, PointsAreColouredByResidualWithTrails) {
  const CameraIntrinsics camera = pinhole(320, 240);
  CameraRenderer renderer = makeRenderer(camera);
  const GreyPicture floor = tiledFloor(camera, lookAt({0.25, -0.4, -0.6}, {0.05, 0.0, 0.05}));
  const RgbPicture picture = drawn(320, 240, [&](const Viewport& viewport) {
    for (int frame = 0; frame < 8; ++frame) {
      EXPECT_TRUE(renderer.drawPicture(floor.luma(), viewport).ok());
      const std::vector<TrackedPoint> points = gridOfPoints(camera, frame);
      EXPECT_TRUE(renderer.drawPoints(points, TrackerKind::indirect, viewport).ok());
    }
  });
  EXPECT_TRUE(looksAsGolden(picture, "camera_points"));
}

}  // namespace
}  // namespace glide::test
