#include "optimize/sim3_optimizer.h"

#include "support/sim3_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

using test::makeSim3Pairs;
using test::similarityError;

constexpr double kGate = 5.991;

class Sim3Optimizer : public testing::TestWithParam<DistortionModel> {
 protected:
  Sim3d guess() const {
    Vec7d delta;
    delta << 0.1, -0.08, 0.1, 0.03, -0.02, 0.03, 0.1;
    return Sim3d::exp(delta) * S_a_b_;
  }

  const CameraModel camera_ = test::syntheticCamera(GetParam());
  const Sim3d S_a_b_ = test::someSimilarity();
};

TEST_P(Sim3Optimizer, DiffersAsCentralDifferencesOfALeftPerturbationDo) {
  constexpr double kStep = 1e-6;
  for (Sim3Pair pair : makeSim3Pairs(camera_, S_a_b_, {.pairs = 10, .noise_px = 5.0})) {
    pair.inv_sigma_a = 0.7;
    pair.inv_sigma_b = 0.4;
    const Sim3d S_a_b = guess();
    const auto lin = linearizeSim3(camera_, S_a_b, pair);
    ASSERT_TRUE(lin.has_value());
    for (int i = 0; i < 7; ++i) {
      const Vec7d delta = kStep * Vec7d::Unit(i);
      const auto after = linearizeSim3(camera_, Sim3d::exp(delta) * S_a_b, pair);
      const auto before = linearizeSim3(camera_, Sim3d::exp(-delta) * S_a_b, pair);
      const Vec5d numeric = (after->r - before->r) / (2.0 * kStep);
      EXPECT_LT((lin->J_r_sim.col(i) - numeric).norm(), 1e-4) << "column " << i;
    }
  }
}

TEST_P(Sim3Optimizer, ResidualsAreBothPixelErrorsAndTheDepthInSigmas) {
  Sim3Pair pair = makeSim3Pairs(camera_, S_a_b_, {.pairs = 1}).front();
  pair.uv_a.x() -= 2.0;
  pair.uv_b.y() -= 3.0;
  pair.inv_sigma_b = 0.5;
  const auto lin = linearizeSim3(camera_, S_a_b_, pair);
  ASSERT_TRUE(lin.has_value());
  EXPECT_LT((lin->r.head<4>() - Eigen::Vector4d(2.0, 0.0, 0.0, 1.5)).norm(), 1e-9);
  EXPECT_NEAR(lin->r(4), 0.0, 1e-9);
  pair.p_a *= 1.1;
  EXPECT_NEAR(linearizeSim3(camera_, S_a_b_, pair)->r(4), -std::log(1.1) / kLogDepthSigma, 1e-9);
}

TEST_P(Sim3Optimizer, RecoversTheTruthFromExactPairs) {
  const auto pairs = makeSim3Pairs(camera_, S_a_b_, {.pairs = 40});
  const Sim3Estimate estimate = optimizeSim3(camera_, pairs, guess(), kGate);
  ASSERT_TRUE(estimate.valid);
  EXPECT_LT(similarityError(estimate.S_a_b, S_a_b_), 1e-8);
  EXPECT_EQ(estimate.inliers, 40);
}

TEST_P(Sim3Optimizer, LeavesOutliersOut) {
  const auto pairs = makeSim3Pairs(
      camera_, S_a_b_, {.pairs = 120, .noise_px = 0.5, .outlier_share = 0.25, .seed = 2});
  const Sim3Estimate estimate = optimizeSim3(camera_, pairs, guess(), kGate);
  ASSERT_TRUE(estimate.valid);
  EXPECT_LT(similarityError(estimate.S_a_b, S_a_b_), 0.02);
  EXPECT_LE(std::count(estimate.inlier.begin(), estimate.inlier.begin() + 30, true), 1);
  EXPECT_GE(std::count(estimate.inlier.begin() + 30, estimate.inlier.end(), true), 85);
  EXPECT_NEAR(estimate.rms_px, 0.7, 0.1);  // two axes
}

TEST_P(Sim3Optimizer, RefusesTooFewPairs) {
  const auto pairs = makeSim3Pairs(camera_, S_a_b_, {.pairs = 5});
  EXPECT_FALSE(optimizeSim3(camera_, pairs, S_a_b_, kGate).valid);
}

TEST_P(Sim3Optimizer, TellsTheScaleOfCamerasAtOnePlaceByTheDepths) {
  Sim3d S_a_b = S_a_b_;
  S_a_b.t.setZero();  // both images are the same whatever the scale
  auto pairs = makeSim3Pairs(camera_, S_a_b, {.pairs = 100, .noise_px = 0.5});
  std::mt19937_64 random(3);
  for (Sim3Pair& pair : pairs) {
    pair.p_a *= std::exp(test::randomVector(0.05, &random).x());
  }
  Sim3d guess = S_a_b;
  guess.s *= 1.2;
  const Sim3Estimate estimate = optimizeSim3(camera_, pairs, guess, kGate);
  ASSERT_TRUE(estimate.valid);
  EXPECT_NEAR(estimate.S_a_b.s / S_a_b.s, 1.0, 0.02);
}

TEST_P(Sim3Optimizer, RefusesARotationThatNothingHolds) {
  // All points at one place: the rotation about it is free.
  const std::vector<Sim3Pair> pairs(20, makeSim3Pairs(camera_, S_a_b_, {.pairs = 1}).front());
  EXPECT_FALSE(optimizeSim3(camera_, pairs, S_a_b_, kGate).valid);
}

INSTANTIATE_TEST_SUITE_P(Lenses,
                         Sim3Optimizer,
                         testing::Values(DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

}  // namespace
}  // namespace glide
