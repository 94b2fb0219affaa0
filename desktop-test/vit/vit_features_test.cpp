#include "vit/vit_features.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

CameraIntrinsics givenCamera() {
  CameraIntrinsics camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 500.0;
  camera.cx = 320.0;
  camera.cy = 240.0;
  return camera;
}

MapView mapWithALandmark() {
  MapView map;
  map.landmarks.push_back({7, {0.2, 0.0, 2.0}, 3});
  return map;
}

TEST(VitFeatures, TellsIdPixelAndDepth) {
  const auto features = visibleFeatures(mapWithALandmark(), givenCamera(), SE3d{});
  ASSERT_EQ(features.size(), 1U);
  EXPECT_EQ(features[0].id, 7);
  EXPECT_FLOAT_EQ(features[0].u, 370.0F);
  EXPECT_FLOAT_EQ(features[0].v, 240.0F);
  EXPECT_FLOAT_EQ(features[0].depth, 2.0F);
}

TEST(VitFeatures, ProjectsWithTheCameraThatTheMapHasCorrected) {
  MapView map = mapWithALandmark();
  map.corrected_camera = givenCamera();
  map.corrected_camera->fx = 600.0;
  const auto features = visibleFeatures(map, givenCamera(), SE3d{});
  ASSERT_EQ(features.size(), 1U);
  EXPECT_FLOAT_EQ(features[0].u, 380.0F);
}

}  // namespace
}  // namespace glide::test
