#include "geometry/p3p.h"

#include "unit/geometry/random_geometry.h"
#include "unit/geometry/two_view_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace glide {
namespace {

PointBearings observe(const SE3d& T_cam_world, const std::array<Vec3d, 3>& p_cam) {
  PointBearings points;
  for (std::size_t i = 0; i < 3; ++i) {
    points.p_world[i] = T_cam_world.inverse() * p_cam[i];
    points.bearing[i] = p_cam[i].normalized();
  }
  return points;
}

TEST(P3p, HasTheTruthAmongItsSolutions) {
  test::RandomGeometry random(1);
  for (int i = 0; i < 1000; ++i) {
    const SE3d T_cam_world = random.transform(random.uniform(0.0, 3.0), 5.0);
    std::array<Vec3d, 3> p_cam;
    for (Vec3d& p : p_cam) p = random.vector(1.0) + Vec3d(0.0, 0.0, 4.0);
    double best = std::numeric_limits<double>::infinity();
    for (const SE3d& found : solveP3p(observe(T_cam_world, p_cam))) {
      best = std::min(best, (found * T_cam_world.inverse()).log().norm());
    }
    EXPECT_LT(best, 1e-6) << i;
  }
}

TEST(P3p, EverySolutionSeesThePointsAlongTheirBearings) {
  test::RandomGeometry random(2);
  for (int i = 0; i < 200; ++i) {
    std::array<Vec3d, 3> p_cam;
    for (Vec3d& p : p_cam) p = random.vector(1.5) + Vec3d(0.0, 0.0, 4.0);
    const PointBearings points = observe(random.transform(1.0, 2.0), p_cam);
    const std::vector<SE3d> poses = solveP3p(points);
    EXPECT_LE(poses.size(), 4U);
    for (const SE3d& T_cam_world : poses) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec3d bearing = (T_cam_world * points.p_world[j]).normalized();
        EXPECT_LT((bearing - points.bearing[j]).norm(), 1e-5);
      }
    }
  }
}

TEST(P3p, SeesBehindNinetyDegrees) {
  const SE3d T_cam_world{so3Exp(Vec3d(0.1, 0.2, -0.1)), Vec3d(0.3, 0.1, 0.2)};
  const PointBearings points =
      observe(T_cam_world, {Vec3d(3.0, 0.2, -0.4), Vec3d(0.5, 2.0, 1.0), Vec3d(-1.0, -0.3, 2.0)});
  double best = std::numeric_limits<double>::infinity();
  for (const SE3d& found : solveP3p(points)) {
    best = std::min(best, (found * T_cam_world.inverse()).log().norm());
  }
  EXPECT_LT(best, 1e-8);
}

TEST(P3p, RefusesCollinearPoints) {
  EXPECT_TRUE(solveP3p(observe(SE3d{}, {Vec3d(0, 0, 3), Vec3d(1, 0, 3), Vec3d(2, 0, 3)})).empty());
}

}  // namespace
}  // namespace glide
