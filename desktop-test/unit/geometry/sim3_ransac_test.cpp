#include "geometry/sim3_ransac.h"

#include "support/sim3_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

using test::makeSim3Pairs;
using test::similarityError;

class Sim3Ransac : public testing::TestWithParam<DistortionModel> {
 protected:
  const CameraModel camera_ = test::syntheticCamera(GetParam());
  const Sim3d S_a_b_ = test::someSimilarity();
  const Sim3RansacOptions options_{};
};

TEST_P(Sim3Ransac, RecoversTheTruthFromExactPairs) {
  const auto pairs = makeSim3Pairs(camera_, S_a_b_, {.pairs = 20});
  const auto result = solveSim3(camera_, pairs, options_);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(similarityError(result->S_a_b, S_a_b_), 1e-9);
  EXPECT_EQ(result->inliers, 20);
}

TEST_P(Sim3Ransac, TellsTwoThirdsOfOutliersFromTheRest) {
  const auto pairs = makeSim3Pairs(
      camera_, S_a_b_, {.pairs = 150, .noise_px = 0.5, .outlier_share = 2.0 / 3.0, .seed = 2});
  const auto result = solveSim3(camera_, pairs, options_);
  ASSERT_TRUE(result.has_value());
  EXPECT_LT(similarityError(result->S_a_b, S_a_b_), 0.05);
  EXPECT_LE(std::count(result->inlier.begin(), result->inlier.begin() + 100, true), 2);
  EXPECT_GE(std::count(result->inlier.begin() + 100, result->inlier.end(), true), 45);
  EXPECT_EQ(std::count(result->inlier.begin(), result->inlier.end(), true), result->inliers);
}

TEST_P(Sim3Ransac, RefusesPairsThatHaveNothingInCommon) {
  const auto pairs = makeSim3Pairs(camera_, S_a_b_, {.pairs = 150, .outlier_share = 1.0});
  EXPECT_FALSE(solveSim3(camera_, pairs, options_).has_value());
}

TEST_P(Sim3Ransac, RefusesTooFewPairs) {
  const auto pairs = makeSim3Pairs(camera_, S_a_b_, {.pairs = options_.min_inliers - 1});
  EXPECT_FALSE(solveSim3(camera_, pairs, options_).has_value());
}

TEST_P(Sim3Ransac, GivesTheSameResultForTheSameSeed) {
  const auto pairs = makeSim3Pairs(
      camera_, S_a_b_, {.pairs = 100, .noise_px = 1.0, .outlier_share = 0.5, .seed = 3});
  const auto first = solveSim3(camera_, pairs, options_);
  const auto second = solveSim3(camera_, pairs, options_);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->S_a_b.t, second->S_a_b.t);
  EXPECT_EQ(first->inlier, second->inlier);
}

TEST_P(Sim3Ransac, MeasuresTheWorstOfBothImagesAndTheDepth) {
  Sim3Pair pair = makeSim3Pairs(camera_, S_a_b_, {.pairs = 1}).front();
  pair.uv_a.x() += 1.0;
  pair.uv_b.y() += 3.0;
  pair.inv_sigma_b = 0.5;
  EXPECT_NEAR(pairError2(camera_, S_a_b_, pair), 2.25, 1e-9);
  pair.uv_b.y() -= 3.0;
  Sim3Pair nearer = pair;
  nearer.p_b *= 0.5;
  EXPECT_GT(pairError2(camera_, S_a_b_, nearer), 4.0);
  pair.p_b.z() = -pair.p_b.z();
  if (GetParam() == DistortionModel::radial_tangential) {
    EXPECT_TRUE(std::isinf(pairError2(camera_, S_a_b_, pair)));
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses,
                         Sim3Ransac,
                         testing::Values(DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

}  // namespace
}  // namespace glide
