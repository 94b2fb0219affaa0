#include "geometry/patch_warp.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

CameraModel makeCamera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = intrinsics.fy = 500.0;
  intrinsics.cx = 320.0;
  intrinsics.cy = 240.0;
  return CameraModel::create(intrinsics).value();
}

TEST(PatchWarp, IsTheIdentityForTheSameView) {
  const auto A = patchWarp(makeCamera(), SE3d{}, Vec3d(0.2, -0.1, 2.0));
  ASSERT_TRUE(A.has_value());
  EXPECT_LT((*A - Mat2d::Identity()).norm(), 1e-9);
}

TEST(PatchWarp, GrowsWhenTheCameraComesCloser) {
  SE3d T_target_source;
  T_target_source.t = Vec3d(0.0, 0.0, -1.0);
  const auto A = patchWarp(makeCamera(), T_target_source, Vec3d(0.0, 0.0, 2.0));
  ASSERT_TRUE(A.has_value());
  EXPECT_LT((*A - 2.0 * Mat2d::Identity()).norm(), 1e-6);
}

TEST(PatchWarp, TurnsWithTheRollOfTheCamera) {
  SE3d T_target_source;
  T_target_source.q = so3Exp(Vec3d(0.0, 0.0, 0.5));
  const auto A = patchWarp(makeCamera(), T_target_source, Vec3d(0.0, 0.0, 2.0));
  ASSERT_TRUE(A.has_value());
  EXPECT_LT((*A - Eigen::Rotation2Dd(0.5).toRotationMatrix()).norm(), 1e-6);
}

TEST(PatchWarp, DoesNotExistBehindTheTarget) {
  SE3d T_target_source;
  T_target_source.t = Vec3d(0.0, 0.0, -3.0);
  EXPECT_FALSE(patchWarp(makeCamera(), T_target_source, Vec3d(0.0, 0.0, 2.0)).has_value());
}

}  // namespace
}  // namespace glide
