#include "geometry/triangulate.h"

#include "unit/geometry/random_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace glide {
namespace {

/// Turns a bearing by noise of `sigma` radians.
Vec3d noisy(test::RandomGeometry& random, const Vec3d& bearing, double sigma) {
  return (so3Exp(random.vector(sigma)) * bearing).normalized();
}

TEST(Triangulate, RecoversPointsExactlyFromCleanBearings) {
  test::RandomGeometry random(1);
  for (int i = 0; i < 200; ++i) {
    const SE3d T_b_a = random.transform(0.3, 0.5);
    const Vec3d p_a(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(3, 8));
    const std::optional<Vec3d> p = triangulate(T_b_a, p_a.normalized(), (T_b_a * p_a).normalized());
    ASSERT_TRUE(p);
    EXPECT_LT((*p - p_a).norm(), 1e-9);
  }
}

TEST(Triangulate, RefusesParallelRaysAndAMissingBaseline) {
  const SE3d sideways{Eigen::Quaterniond::Identity(), Vec3d(0.1, 0.0, 0.0)};
  EXPECT_FALSE(triangulate(sideways, Vec3d::UnitZ(), Vec3d::UnitZ()));
  EXPECT_FALSE(triangulate(SE3d{}, Vec3d::UnitZ(), Vec3d(0.1, 0.0, 1.0).normalized()));
}

TEST(Triangulate, RefusesPointsBehindEitherCamera) {
  const SE3d T_b_a{Eigen::Quaterniond::Identity(), Vec3d(-0.5, 0.0, 0.0)};  // b stands right of a
  const Vec3d diverging_a = Vec3d(-0.2, 0.0, 1.0).normalized();
  const Vec3d diverging_b = Vec3d(0.2, 0.0, 1.0).normalized();
  EXPECT_FALSE(triangulate(T_b_a, diverging_a, diverging_b));
  EXPECT_TRUE(triangulate(T_b_a, diverging_b, diverging_a));
}

TEST(Triangulate, FindsTheSmallestCorrectionOfNoisyBearings) {
  test::RandomGeometry random(2);
  for (int i = 0; i < 100; ++i) {
    const SE3d T_b_a = random.transform(0.1, 0.5);
    const Vec3d p_a(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(3, 6));
    const Vec3d bearing_a = noisy(random, p_a.normalized(), 1e-3);
    const Vec3d bearing_b = noisy(random, (T_b_a * p_a).normalized(), 1e-3);
    const std::optional<Vec3d> p = triangulate(T_b_a, bearing_a, bearing_b);
    ASSERT_TRUE(p);
    const auto cost = [&](const Vec3d& q) {
      return q.normalized().cross(bearing_a).squaredNorm() +
             (T_b_a * q).normalized().cross(bearing_b).squaredNorm();
    };
    const double best = cost(*p);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(cost(*p + 1e-3 * Vec3d::Unit(axis)), best);
      EXPECT_GE(cost(*p - 1e-3 * Vec3d::Unit(axis)), best);
    }
  }
}

TEST(Triangulate, IsUnbiasedAtLowParallax) {
  test::RandomGeometry random(3);
  const SE3d T_b_a{Eigen::Quaterniond::Identity(), Vec3d(-0.1, 0.0, 0.0)};
  const Vec3d p_a(0.3, 0.2, 4.0);  // 1.4 degrees
  std::vector<double> inverse_depths;
  for (int i = 0; i < 2001; ++i) {
    const std::optional<Vec3d> p = triangulate(T_b_a,
                                               noisy(random, p_a.normalized(), 1e-3),
                                               noisy(random, (T_b_a * p_a).normalized(), 1e-3));
    if (p) inverse_depths.push_back(1.0 / p->z());
  }
  std::nth_element(inverse_depths.begin(), inverse_depths.begin() + 1000, inverse_depths.end());
  EXPECT_NEAR(inverse_depths[1000], 0.25, 0.25 * 0.01);
}

TEST(Triangulate, ParallaxIsTheAngleAtThePoint) {
  const double angle =
      parallaxAngle(Vec3d(0.0, 0.0, 1.0), Vec3d(0.0, 0.0, 0.0), Vec3d(1.0, 0.0, 0.0));
  EXPECT_NEAR(angle, std::atan(1.0), 1e-15);
  EXPECT_EQ(parallaxAngle(Vec3d::UnitZ(), Vec3d::Zero(), Vec3d::Zero()), 0.0);
}

}  // namespace
}  // namespace glide
