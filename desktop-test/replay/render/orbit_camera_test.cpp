#include "replay/render/orbit_camera.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr Lens kWide{1.0, 2.0};
constexpr Lens kTall{1.0, 0.5};

Eigen::Matrix4f matrix(const Matrix4& m) { return Eigen::Map<const Eigen::Matrix4f>(m.data()); }

/// Normalised device coordinates of a world point.
Vec3d project(const ViewCamera& camera, const Vec3d& p_world) {
  const Eigen::Vector4f clip =
      matrix(camera.projection) * matrix(camera.view) * p_world.homogeneous().cast<float>();
  return (clip.head<3>() / clip.w()).cast<double>();
}

Orbit someOrbit() {
  Orbit orbit;
  orbit.focus = {1.0, -2.0, 5.0};
  orbit.azimuth = 0.4;
  orbit.elevation = 0.5;
  orbit.distance = 3.0;
  return orbit;
}

TEST(OrbitCamera, SeesItsFocusInTheMiddleAtItsDistance) {
  const Orbit orbit = someOrbit();
  EXPECT_NEAR((eyeOf(orbit) - orbit.focus).norm(), orbit.distance, 1e-12);
  const ViewCamera camera = viewOf(orbit, kWide);
  EXPECT_NEAR(project(camera, orbit.focus).head<2>().norm(), 0.0, 1e-5);
  const Eigen::Vector4f eye = matrix(camera.view) * orbit.focus.homogeneous().cast<float>();
  EXPECT_NEAR(eye.z(), -orbit.distance, 1e-5);
}

TEST(OrbitCamera, KeepsUpUpAndRightRight) {
  Orbit orbit;  // behind the first keyframe's camera, looking where it looks
  const ViewCamera camera = viewOf(orbit, kWide);
  EXPECT_GT(project(camera, {0.1, 0.0, 0.0}).x(), 0.01);   // the camera's x is to the right
  EXPECT_LT(project(camera, {0.0, 0.1, 0.0}).y(), -0.01);  // its y is down
  EXPECT_GT(project(camera, {0.0, 0.0, 0.1}).z(), project(camera, Vec3d::Zero()).z());
}

TEST(OrbitCamera, StandsHigherWithElevationAndTurnsLeftWithAzimuth) {
  Orbit orbit;
  orbit.elevation = 0.5;
  EXPECT_NEAR(eyeOf(orbit).dot(orbit.up), std::sin(0.5), 1e-12);
  orbit.elevation = 0.0;
  orbit.azimuth = 0.5;  // it looks to the left of `ahead`, so it stands to the right of the focus
  EXPECT_NEAR(eyeOf(orbit).x(), std::sin(0.5), 1e-12);
}

TEST(OrbitCamera, KnowsFromWhereAPointLiesOnThePicturesEdge) {
  for (const Lens& lens : {kWide, kTall}) {
    for (const Vec3d& offset : {Vec3d(0.9, 0.1, 0.2), Vec3d(-0.1, 0.8, -0.6), Vec3d(0, -0.7, 1)}) {
      Orbit orbit = someOrbit();
      const Vec3d p = orbit.focus + offset;
      orbit.distance = distanceToSee(p, orbit, lens.field_of_view);
      const Vec3d seen = project(viewOf(orbit, lens), p);
      const double x = std::abs(seen.x()) * std::max(1.0, lens.aspect);
      const double y = std::abs(seen.y()) / std::min(1.0, lens.aspect);
      EXPECT_NEAR(std::max(x, y), 1.0, 1e-4);
    }
  }
}

TEST(OrbitCamera, DrawsASquareAsASquare) {
  for (const Lens& lens : {kWide, kTall}) {
    const ViewCamera camera = viewOf(Orbit{}, lens);
    const double width = project(camera, {0.1, 0.0, 0.0}).x() * lens.aspect;
    EXPECT_NEAR(width, -project(camera, {0.0, 0.1, 0.0}).y(), 1e-6);
  }
}

TEST(OrbitCamera, TakesTheLevelPartUnlessTheDirectionIsSteep) {
  const Vec3d up(0.0, -1.0, 0.0), otherwise(1.0, 0.0, 0.0);
  EXPECT_NEAR((levelPart({0.0, 3.0, 4.0}, up, otherwise) - Vec3d(0, 0, 1)).norm(), 0.0, 1e-12);
  EXPECT_EQ(levelPart({0.0, 1.0, 0.01}, up, otherwise), otherwise);
}

}  // namespace
}  // namespace glide::replay
