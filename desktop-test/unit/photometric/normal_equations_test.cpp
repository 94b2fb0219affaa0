#include "photometric/normal_equations.h"

#include "photometric/aligned_vector.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <limits>
#include <random>
#include <vector>

namespace glide {
namespace {

template <class Matrix>
Matrix randomMatrix(std::mt19937* random) {
  std::normal_distribution<double> normal(0.0, 1.0);
  Matrix out;
  for (int i = 0; i < out.size(); ++i) out(i) = normal(*random);
  return out;
}

/// A system whose unknowns differ in scale as translations and rotations do.
NormalEquations randomSystem(const Vec6d& solution) {
  std::mt19937 random(7);
  Eigen::Matrix<double, 30, 6> A = randomMatrix<Eigen::Matrix<double, 30, 6>>(&random);
  A.rightCols<3>() *= 100.0;
  NormalEquations normals;
  normals.H = A.transpose() * A;
  normals.b = normals.H * solution;
  return normals;
}

TEST(NormalEquations, SumTheWeightedPointsOnEveryInstructionSet) {
  std::mt19937 random(3);
  AlignedVector<PointNormal> points;
  std::vector<NormalTerm> terms;
  NormalEquations expected;
  std::vector<Mat26d> derivatives;
  for (int i = 0; i < 20; ++i) {
    const Mat26d J = randomMatrix<Mat26d>(&random);
    const Vec3d g(3.0 + i, 0.5 * i, 2.0 + i);
    const Vec3d values = randomMatrix<Vec3d>(&random);
    Mat2d G;
    G << g.x(), g.y(), g.y(), g.z();
    const double w = 0.1 * i;
    points.push_back(makePointNormal(J, g));
    terms.push_back({nullptr, w, values.x(), values.y()});
    expected.H += w * J.transpose() * G * J;
    expected.b += w * J.transpose() * values.head<2>();
  }
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i].point = &points[i];
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    const NormalEquations normals = accumulateNormals(terms);
    EXPECT_TRUE(normals.H.isApprox(expected.H, 1e-12)) << hwy::TargetName(target);
    EXPECT_TRUE(normals.b.isApprox(expected.b, 1e-12)) << hwy::TargetName(target);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(NormalEquations, AreZeroWithoutPoints) {
  const NormalEquations normals = accumulateNormals({});
  EXPECT_EQ(normals.H, Mat6d(Mat6d::Zero()));
  EXPECT_EQ(normals.b, Vec6d(Vec6d::Zero()));
}

TEST(NormalEquations, AreSolvedUpToTheDamping) {
  Vec6d solution;
  solution << 0.1, -0.2, 0.3, 0.01, 0.02, -0.03;
  const std::optional<Vec6d> delta = solveNormals(randomSystem(solution));
  ASSERT_TRUE(delta);
  EXPECT_LT((*delta - solution).norm(), 1e-5 * solution.norm());
}

TEST(NormalEquations, AreSolvedTheSameInEveryUnitOfGreyLevels) {
  NormalEquations normals = randomSystem(Vec6d::Ones());
  const std::optional<Vec6d> before = solveNormals(normals);
  normals.H *= 1e6;
  normals.b *= 1e6;
  const std::optional<Vec6d> after = solveNormals(normals);
  ASSERT_TRUE(before && after);
  EXPECT_LT((*before - *after).norm(), 1e-9);
}

TEST(NormalEquations, DampDirectionsThatNothingConstrains) {
  NormalEquations normals = randomSystem(Vec6d::Ones());
  normals.H.row(2) = normals.H.row(1);
  normals.H.col(2) = normals.H.col(1);
  normals.H(2, 2) = normals.H(1, 1);
  normals.b(2) = normals.b(1);
  const std::optional<Vec6d> delta = solveNormals(normals);
  ASSERT_TRUE(delta);
  EXPECT_NEAR((*delta)(1), (*delta)(2), 1e-3);  // shared evenly instead of blowing up
  EXPECT_LT(delta->norm(), 10.0);
}

TEST(NormalEquations, AreRefusedWhenADirectionIsMissing) {
  NormalEquations normals = randomSystem(Vec6d::Ones());
  normals.H.row(4).setZero();
  normals.H.col(4).setZero();
  EXPECT_FALSE(solveNormals(normals));
  EXPECT_FALSE(solveNormals(NormalEquations{}));
}

TEST(NormalEquations, AreRefusedWhenIndefiniteOrNotFinite) {
  NormalEquations indefinite = randomSystem(Vec6d::Ones());
  indefinite.H(0, 1) = indefinite.H(1, 0) = 2.0 * indefinite.H.diagonal().maxCoeff();
  EXPECT_FALSE(solveNormals(indefinite));
  NormalEquations not_finite = randomSystem(Vec6d::Ones());
  not_finite.b(3) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solveNormals(not_finite));
  not_finite.H(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solveNormals(not_finite));
}

}  // namespace
}  // namespace glide
