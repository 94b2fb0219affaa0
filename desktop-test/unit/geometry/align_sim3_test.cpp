#include "geometry/align_sim3.h"

#include "unit/geometry/random_geometry.h"

#include <gtest/gtest.h>

#include <vector>

namespace glide {
namespace {

struct Clouds {
  std::vector<Vec3d> a, b;
};

/// `count` points b of deviation `spread` per axis, and a = S_a_b * b with noise.
Clouds makeClouds(const Sim3d& S_a_b, const Vec3d& spread, int count, double noise) {
  test::RandomGeometry random(17);
  Clouds clouds;
  for (int i = 0; i < count; ++i) {
    clouds.b.push_back(random.vector(1.0).cwiseProduct(spread) + Vec3d(5.0, -3.0, 2.0));
    clouds.a.push_back(S_a_b * clouds.b.back() + random.vector(noise));
  }
  return clouds;
}

Sim3d someSimilarity() { return {so3Exp(Vec3d(0.4, -2.0, 1.1)), Vec3d(3.0, 4.0, -9.0), 3.7}; }

TEST(AlignSim3, RecoversASimilarityExactly) {
  const Sim3d S_a_b = someSimilarity();
  const Clouds clouds = makeClouds(S_a_b, Vec3d(1.0, 2.0, 3.0), 20, 0.0);
  const std::optional<Sim3d> found = alignSim3(clouds.a, clouds.b, AlignScale::estimated);
  ASSERT_TRUE(found);
  EXPECT_LT((S_a_b.inverse() * *found).log().norm(), 1e-12);
}

TEST(AlignSim3, RecoversFromPointsInAPlane) {
  const Sim3d S_a_b = someSimilarity();
  const Clouds clouds = makeClouds(S_a_b, Vec3d(1.0, 2.0, 0.0), 20, 0.0);
  const std::optional<Sim3d> found = alignSim3(clouds.a, clouds.b, AlignScale::estimated);
  ASSERT_TRUE(found);
  EXPECT_LT((S_a_b.inverse() * *found).log().norm(), 1e-12);
}

TEST(AlignSim3, NeverReturnsAReflection) {
  Clouds clouds = makeClouds(Sim3d{}, Vec3d(1.0, 1.0, 0.2), 50, 0.0);
  for (Vec3d& p : clouds.a) p.z() = -p.z();
  const std::optional<Sim3d> found = alignSim3(clouds.a, clouds.b, AlignScale::estimated);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->q.toRotationMatrix().determinant(), 1.0, 1e-12);
  EXPECT_LT(so3Log(found->q).norm(), 0.2);  // the flipped axis is the flattest, so nothing turns
  EXPECT_GT(found->s, 0.5);
}

TEST(AlignSim3, IsTheLeastSquaresMinimum) {
  const Clouds clouds = makeClouds(someSimilarity(), Vec3d(1.0, 2.0, 3.0), 30, 0.3);
  const std::optional<Sim3d> found = alignSim3(clouds.a, clouds.b, AlignScale::estimated);
  ASSERT_TRUE(found);
  const auto cost = [&](const Sim3d& S) {
    double sum = 0.0;
    for (std::size_t i = 0; i < clouds.a.size(); ++i) {
      sum += (clouds.a[i] - S * clouds.b[i]).squaredNorm();
    }
    return sum;
  };
  for (int axis = 0; axis < 7; ++axis) {
    for (const double step : {1e-3, -1e-3}) {
      EXPECT_GT(cost(Sim3d::exp(step * Vec7d::Unit(axis)) * *found), cost(*found)) << axis;
    }
  }
}

TEST(AlignSim3, KeepsAFixedScale) {
  const Sim3d S_a_b{so3Exp(Vec3d(0.4, -2.0, 1.1)), Vec3d(3.0, 4.0, -9.0), 1.0};
  const Clouds clouds = makeClouds(S_a_b, Vec3d(1.0, 2.0, 3.0), 20, 0.0);
  const std::optional<Sim3d> found = alignSim3(clouds.a, clouds.b, AlignScale::fixed);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->s, 1.0);
  EXPECT_LT((S_a_b.inverse() * *found).log().norm(), 1e-12);
}

TEST(AlignSim3, RefusesTooFewAndCollinearPoints) {
  const Clouds two = makeClouds(Sim3d{}, Vec3d(1.0, 2.0, 3.0), 2, 0.0);
  EXPECT_FALSE(alignSim3(two.a, two.b, AlignScale::estimated));
  const Clouds line = makeClouds(someSimilarity(), Vec3d(0.0, 2.0, 0.0), 20, 0.0);
  EXPECT_FALSE(alignSim3(line.a, line.b, AlignScale::estimated));
  const Clouds dot = makeClouds(someSimilarity(), Vec3d(0.0, 0.0, 0.0), 20, 0.0);
  EXPECT_FALSE(alignSim3(dot.a, dot.b, AlignScale::estimated));
}

}  // namespace
}  // namespace glide
