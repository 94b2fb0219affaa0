#include "ar/display.h"

#include "ar/axes.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

CameraModel phone() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = 500.0;
  intrinsics.fy = 510.0;
  intrinsics.cx = 330.0;
  intrinsics.cy = 228.0;
  return CameraModel::create(intrinsics).value();
}

/// Normalised device coordinates of a point of the camera (OpenCV axes).
Vec3d toNdc(const Display& display, const Vec3d& p_cam) {
  const Vec3d p_gl = viewRotation(display) * (appFromCv(AppAxes::gl) * p_cam);
  const Vec4d clip = projectionMatrix(phone(), display, {0.1, 100.0}) * p_gl.homogeneous();
  return clip.hnormalized();
}

/// The same from the pixel: x right, y up, the image's border at -1 and 1.
Vec2d imageNdc(const Vec3d& p_cam) {
  const Vec2d uv = *phone().project(p_cam);
  return {2.0 * (uv.x() + 0.5) / 640.0 - 1.0, 1.0 - 2.0 * (uv.y() + 0.5) / 480.0};
}

const Vec3d kPoint(0.4, -0.3, 2.0);

TEST(Display, PutsPixelsWhereTheImageHasThem) {
  const Vec3d ndc = toNdc({0, 640, 480}, kPoint);
  EXPECT_TRUE(ndc.head<2>().isApprox(imageNdc(kPoint), 1e-12));
}

TEST(Display, TurnsClockwiseByTheRotation) {
  const Vec2d upright = imageNdc(kPoint);
  const Vec3d quarter = toNdc({90, 480, 640}, kPoint);
  EXPECT_TRUE(quarter.head<2>().isApprox(Vec2d(upright.y(), -upright.x()), 1e-12));
  const Vec3d half = toNdc({180, 640, 480}, kPoint);
  EXPECT_TRUE(half.head<2>().isApprox(Vec2d(-upright), 1e-12));
  const Vec3d three_quarters = toNdc({270, 480, 640}, kPoint);
  EXPECT_TRUE(three_quarters.head<2>().isApprox(Vec2d(-upright.y(), upright.x()), 1e-12));
}

TEST(Display, CropsTheImageAboutItsCentreToFillTheScreen) {
  const Vec2d image = imageNdc(kPoint);
  const Vec3d tall = toNdc({0, 480, 480}, kPoint);  // the image is wider: left and right are cut
  EXPECT_NEAR(tall.x(), image.x() * 640.0 / 480.0, 1e-12);
  EXPECT_NEAR(tall.y(), image.y(), 1e-12);
  const Vec3d wide = toNdc({0, 1280, 480}, kPoint);
  EXPECT_NEAR(wide.x(), image.x(), 1e-12);
  EXPECT_NEAR(wide.y(), image.y() * 2.0, 1e-12);
}

TEST(Display, MapsTheClipPlanesToTheEndsOfDepth) {
  EXPECT_NEAR(toNdc({0, 0, 0}, {0.0, 0.0, 0.1}).z(), -1.0, 1e-9);
  EXPECT_NEAR(toNdc({0, 0, 0}, {0.0, 0.0, 100.0}).z(), 1.0, 1e-9);
}

}  // namespace
}  // namespace glide
