#include "ar/app_world.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

constexpr double kTolerance = 1e-12;

SE3d someCamera() {
  Vec6d twist;
  twist << 0.4, -1.2, 2.0, 0.3, -0.5, 0.7;
  return SE3d::exp(twist);
}

double difference(const SE3d& a, const SE3d& b) { return (a.inverse() * b).log().norm(); }

TEST(AppWorld, ShowsTheFirstCameraUprightAndLookingAlongMinusZ) {
  const AppWorld world(AppAxes::gl);
  EXPECT_LT(difference(world.cameraToApp(SE3d{}), SE3d{}), kTolerance);
  EXPECT_NEAR(world.cameraToApp(SE3d{}).q.w(), 1.0, kTolerance);
  // A point in front of, right of and below the camera.
  EXPECT_TRUE(world.pointToApp({1.0, 2.0, 3.0}).isApprox(Vec3d(1.0, -2.0, -3.0)));
}

TEST(AppWorld, LeavesOpenCvAxesAlone) {
  const AppWorld world(AppAxes::cv);
  EXPECT_LT(difference(world.cameraToApp(someCamera()), someCamera()), kTolerance);
}

class AppWorldAxesTest : public ::testing::TestWithParam<AppAxes> {};

TEST_P(AppWorldAxesTest, TakesCamerasAndObjectsThereAndBack) {
  AppWorld world(GetParam());
  world.scaleBy(2.5);
  world.level(someCamera(), {0.2, -0.9, 0.1});
  EXPECT_LT(difference(world.cameraFromApp(world.cameraToApp(someCamera())), someCamera()), 1e-9);
  EXPECT_LT(difference(world.objectFromApp(world.objectToApp(someCamera())), someCamera()), 1e-9);
}

TEST_P(AppWorldAxesTest, KeepsPointsWhereCamerasSeeThem) {
  AppWorld world(GetParam());
  world.scaleBy(0.3);
  world.level(someCamera(), {0.1, 1.0, 0.4});
  const Vec3d p_cam(0.3, -0.2, 4.0);
  const Vec3d p_app = world.pointToApp(someCamera() * p_cam);
  const Vec3d p_app_cam = world.cameraToApp(someCamera()).inverse() * p_app;
  EXPECT_TRUE(p_app_cam.isApprox(0.3 * (appFromCv(GetParam()) * p_cam), 1e-9));
}

TEST_P(AppWorldAxesTest, TurnsTheWorldUntilGravityPointsDown) {
  AppWorld world(GetParam());
  const Vec3d down_cam = Vec3d(0.3, -0.8, 0.5).normalized();
  world.level(someCamera(), down_cam);
  EXPECT_TRUE((world.cameraToApp(someCamera()).q * down_cam).isApprox(-upOf(GetParam()), 1e-9));
}

INSTANTIATE_TEST_SUITE_P(BothAxes, AppWorldAxesTest, ::testing::Values(AppAxes::gl, AppAxes::cv));

TEST(AppWorld, ForgetsScaleAndGravityWithItsMap) {
  AppWorld world(AppAxes::gl);
  world.scaleBy(3.0);
  world.level(someCamera(), {0.3, -0.8, 0.5});
  world.reset();
  EXPECT_LT(difference(world.cameraToApp(SE3d{}), SE3d{}), kTolerance);
  EXPECT_EQ(world.scale(), 1.0);
}

}  // namespace
}  // namespace glide
