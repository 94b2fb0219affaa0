#include "vit/vit_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace glide::test {
namespace {

using Transform = std::array<double, 16>;

constexpr Transform kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Result<VitCamera> cameraWith(const Transform& transform) {
  vit_camera_calibration calibration{};
  calibration.width = 640;
  calibration.height = 480;
  calibration.fx = calibration.fy = 500.0;
  calibration.cx = 320.0;
  calibration.cy = 240.0;
  std::copy(transform.begin(), transform.end(), calibration.transform);
  return toCamera(calibration);
}

Transform identityBut(std::size_t index, double value) {
  Transform transform = kIdentity;
  transform[index] = value;
  return transform;
}

TEST(VitFrame, TakesTheCamerasPlaceOnTheHeadset) {
  // A quarter turn about z, in three digits as calibration files have them.
  const Result<VitCamera> camera =
      cameraWith({0.001, -1, 0, 0.1, 1, 0.001, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1});
  ASSERT_TRUE(camera);
  const Vec3d p_imu = camera->T_imu_cam * Vec3d(1.0, 0.0, 0.0);
  EXPECT_LT((p_imu - Vec3d(0.1, 1.2, 0.3)).norm(), 0.01);
}

TEST(VitFrame, TakesATransformThatWasNotFilledInForTheIdentity) {
  const Result<VitCamera> camera = cameraWith(Transform{});
  ASSERT_TRUE(camera);
  EXPECT_LT((camera->T_imu_cam.matrix() - SE3d{}.matrix()).norm(), 1e-12);
}

TEST(VitFrame, RefusesATransformWithoutARotation) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Transform broken[] = {identityBut(0, 1.5),        // stretched
                              identityBut(1, 0.3),        // sheared
                              identityBut(10, -1.0),      // a mirror
                              identityBut(5, kNan),       // of the rotation
                              identityBut(3, kNan),       // of the translation
                              identityBut(7, kInfinity),  // of the translation
                              {0, 0, 0, 0.1}};            // a translation alone
  for (const Transform& transform : broken) {
    const Result<VitCamera> camera = cameraWith(transform);
    ASSERT_FALSE(camera) << testing::PrintToString(transform);
    EXPECT_EQ(camera.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(camera.error().message, testing::HasSubstr("transform"));
  }
}

}  // namespace
}  // namespace glide::test
