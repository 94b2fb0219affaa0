#include "optimize/similarity_cost.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace glide {
namespace {

constexpr double kStep = 1e-6;

using RowMat78d = Eigen::Matrix<double, 7, 8, Eigen::RowMajor>;
using RowMat87d = Eigen::Matrix<double, 8, 7, Eigen::RowMajor>;

Vec7d tangent(double size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Vec7d x;
  for (int i = 0; i < 7; ++i) x(i) = uniform(random);
  return size * x.normalized();
}

double distance(const Sim3d& a, const Sim3d& b) { return (a * b.inverse()).log().norm(); }

TEST(SimilarityBlock, KeepsTheSimilarity) {
  const Sim3d S = Sim3d::exp(tangent(1.5, 1));
  EXPECT_LT(distance(fromSimilarityBlock(toSimilarityBlock(S).data()), S), 1e-12);
}

TEST(LeftSimilarityManifold, MovesFromTheLeftAndMinusUndoesPlus) {
  const LeftSimilarityManifold manifold{};
  const Sim3d S = Sim3d::exp(tangent(1.5, 1));
  const Vec7d delta = tangent(0.7, 2);
  const Vec8d x = toSimilarityBlock(S);
  Vec8d moved;
  ASSERT_TRUE(manifold.Plus(x.data(), delta.data(), moved.data()));
  EXPECT_LT(distance(fromSimilarityBlock(moved.data()), Sim3d::exp(delta) * S), 1e-12);
  Vec7d back;
  ASSERT_TRUE(manifold.Minus(moved.data(), x.data(), back.data()));
  EXPECT_LT((back - delta).norm(), 1e-12);
}

TEST(LeftSimilarityManifold, RefusesAStepThatIsNotFinite) {
  const LeftSimilarityManifold manifold{};
  const Vec7d delta = Vec7d::Constant(NAN);
  const Vec8d x = toSimilarityBlock(Sim3d{});
  Vec8d moved;
  EXPECT_FALSE(manifold.Plus(x.data(), delta.data(), moved.data()));
}

TEST(LeftSimilarityManifold, StaysFiniteAlongAGradientOfALongLoop) {
  const LeftSimilarityManifold manifold{};
  const Vec7d delta = Vec7d::Constant(1e5);
  const Vec8d x = toSimilarityBlock(Sim3d{});
  Vec8d moved;
  EXPECT_TRUE(manifold.Plus(x.data(), delta.data(), moved.data()));
}

TEST(SimilarityAdjoint, CarriesATangentThroughTheSimilarity) {
  const Sim3d S = Sim3d::exp(tangent(1.8, 3));
  const Vec7d x = tangent(0.9, 4);
  EXPECT_LT(distance(S * Sim3d::exp(x), Sim3d::exp(adjoint(S) * x) * S), 1e-12);
}

/// Largest difference from central differences of log(exp(d) exp(x)), relative to the largest
/// entry.
double leftJacobianError(const Vec7d& x) {
  Mat7d numeric;
  for (int i = 0; i < 7; ++i) {
    const Vec7d d = kStep * Vec7d::Unit(i);
    const Vec7d ahead = (Sim3d::exp(d) * Sim3d::exp(x)).log();
    const Vec7d behind = (Sim3d::exp(-d) * Sim3d::exp(x)).log();
    numeric.col(i) = (ahead - behind) / (2.0 * kStep);
  }
  return (leftJacobianInverse(x) - numeric).cwiseAbs().maxCoeff() / numeric.cwiseAbs().maxCoeff();
}

TEST(SimilarityLeftJacobian, EqualsCentralDifferences) {
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    EXPECT_LT(leftJacobianError(tangent(0.1, seed)), 1e-8);
    EXPECT_LT(leftJacobianError(tangent(2.0, seed)), 1e-6);
    EXPECT_LT(leftJacobianError(tangent(3.0, seed)), 1e-3);
  }
}

TEST(SimilarityLeftJacobian, HoldsForLongTranslations) {
  Vec7d x = tangent(0.5, 5);
  x.head<3>() *= 200.0;
  EXPECT_LT(leftJacobianError(x), 1e-6);
}

class SimilarityCostTest : public testing::Test {
 protected:
  Vec7d residual(const Vec8d& a, const Vec8d& b) const {
    const double* parameters[] = {a.data(), b.data()};
    Vec7d r;
    EXPECT_TRUE(cost_.Evaluate(parameters, r.data(), nullptr));
    return r;
  }
  Vec8d moved(const Vec8d& block, const Vec7d& delta) const {
    Vec8d result;
    EXPECT_TRUE(manifold_.Plus(block.data(), delta.data(), result.data()));
    return result;
  }

  const Sim3d S_a_world_ = Sim3d::exp(tangent(1.2, 6));
  const Sim3d S_b_world_ = Sim3d::exp(tangent(1.4, 7));
  const Sim3d S_a_b_ = Sim3d::exp(tangent(0.6, 8)) * S_a_world_ * S_b_world_.inverse();
  const SimilarityCost cost_{S_a_b_, 2.5};
  const LeftSimilarityManifold manifold_{};
  const Vec8d a_ = toSimilarityBlock(S_a_world_), b_ = toSimilarityBlock(S_b_world_);
};

TEST_F(SimilarityCostTest, IsTheWeightedLogarithmOfTheMismatch) {
  EXPECT_LT((residual(a_, b_) - std::sqrt(2.5) * tangent(0.6, 8)).norm(), 1e-12);
  const Vec8d met = toSimilarityBlock(S_a_b_ * S_b_world_);
  EXPECT_LT(residual(met, b_).norm(), 1e-12);
}

TEST_F(SimilarityCostTest, HasTheDerivativesOfCentralDifferencesOnTheManifold) {
  RowMat78d J_a, J_b;
  RowMat87d plus;
  const double* parameters[] = {a_.data(), b_.data()};
  double* jacobians[] = {J_a.data(), J_b.data()};
  Vec7d r;
  ASSERT_TRUE(cost_.Evaluate(parameters, r.data(), jacobians));
  ASSERT_TRUE(manifold_.PlusJacobian(a_.data(), plus.data()));
  EXPECT_EQ(r, residual(a_, b_));
  for (int i = 0; i < 7; ++i) {
    const Vec7d d = kStep * Vec7d::Unit(i);
    const Vec7d by_a = (residual(moved(a_, d), b_) - residual(moved(a_, -d), b_)) / (2.0 * kStep);
    const Vec7d by_b = (residual(a_, moved(b_, d)) - residual(a_, moved(b_, -d))) / (2.0 * kStep);
    EXPECT_LT(((J_a * plus).col(i) - by_a).norm(), 1e-7);
    EXPECT_LT(((J_b * plus).col(i) - by_b).norm(), 1e-7);
  }
}

TEST_F(SimilarityCostTest, WritesOnlyTheDerivativesThatAreAskedFor) {
  RowMat78d J_b = RowMat78d::Zero();
  const double* parameters[] = {a_.data(), b_.data()};
  double* jacobians[] = {nullptr, J_b.data()};
  Vec7d r;
  ASSERT_TRUE(cost_.Evaluate(parameters, r.data(), jacobians));
  EXPECT_GT(J_b.norm(), 0.0);
}

}  // namespace
}  // namespace glide
