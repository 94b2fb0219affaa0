#include "replay/evaluation/accuracy.h"

#include "replay/evaluation/evaluate.h"
#include "replay/evaluation/random_trajectories.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

constexpr std::int64_t kMs = 1'000'000;

Trajectory atTimes(std::initializer_list<double> times_ms) {
  Trajectory trajectory;
  for (const double t : times_ms) {
    trajectory.push_back({static_cast<std::int64_t>(t * 1e6), SE3d{}});
  }
  return trajectory;
}

std::vector<std::pair<std::size_t, std::size_t>> pairsOf(const Trajectory& truth,
                                                         const Trajectory& estimate) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const PosePair& pair : associate(truth, estimate)) {
    pairs.emplace_back(pair.truth, pair.estimate);
  }
  return pairs;
}

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(Associate, TakesTheNearestWithinTenMilliseconds) {
  EXPECT_THAT(pairsOf(atTimes({0, 50, 100, 150, 200}), atTimes({4, 61, 109, 190.5})),
              ElementsAre(Pair(0, 0), Pair(2, 2), Pair(4, 3)));
}

TEST(Associate, GoesThroughTheShorterTrajectory) {
  // The only truth pose lies between two estimates: it is used once.
  EXPECT_THAT(pairsOf(atTimes({100}), atTimes({97, 102})), ElementsAre(Pair(0, 1)));
  // Two estimates beside one truth: as many as the shorter one has, and a truth may serve twice.
  EXPECT_THAT(pairsOf(atTimes({0, 100, 500}), atTimes({97, 102})),
              ElementsAre(Pair(1, 0), Pair(1, 1)));
}

TEST(Associate, TakesTheEarlierOnATie) {
  EXPECT_THAT(pairsOf(atTimes({0, 8, 500}), atTimes({4, 504})),
              ElementsAre(Pair(0, 0), Pair(2, 1)));
}

TEST(Associate, FindsNothingInNothing) { EXPECT_TRUE(pairsOf({}, atTimes({1})).empty()); }

TEST(AbsoluteError, IsZeroForTheSamePathInAnotherWorldAndUnit) {
  const Trajectory truth = smoothPath(0, 50 * kMs, 200);
  const auto error = absoluteError(truth, estimateOf(truth, 0.0, 1));
  ASSERT_TRUE(error.has_value());
  EXPECT_LT(error->rmse_m, 1e-9);
  EXPECT_LT(error->max_m, 1e-9);
  EXPECT_NEAR(error->scale, 1.0 / 0.37, 1e-9);
}

TEST(AbsoluteError, IsTheNoiseThatWasAdded) {
  const Trajectory truth = smoothPath(0, 10 * kMs, 4000);
  const auto error = absoluteError(truth, estimateOf(truth, 0.01, 2));
  ASSERT_TRUE(error.has_value());
  EXPECT_NEAR(error->rmse_m, 0.01 * std::sqrt(3.0), 3e-4);
  EXPECT_GT(error->max_m, error->rmse_m);
}

TEST(AbsoluteError, NeedsThreeMatches) {
  const Trajectory truth = smoothPath(0, 50 * kMs, 2);
  EXPECT_FALSE(absoluteError(truth, estimateOf(truth, 0.0, 1)).has_value());
  EXPECT_FALSE(absoluteError(truth, {}).has_value());
}

TEST(RelativeError, IsZeroForTheSamePathAtAnotherScale) {
  const Trajectory truth = smoothPath(0, 50 * kMs, 100);
  const auto error = relativeError(truth, estimateOf(truth, 0.0, 1), 1.0 / 0.37);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->pairs, 80);
  EXPECT_LT(error->trans_m, 1e-9);
  EXPECT_LT(error->rot_deg, 1e-6);
}

TEST(RelativeError, MeasuresASteadyDriftOverOneSecond) {
  Trajectory truth, estimate;
  for (int i = 0; i < 100; ++i) {
    const double s = i * 0.05;
    truth.push_back({i * 50 * kMs, SE3d{}});
    estimate.push_back({i * 50 * kMs, SE3d{so3Exp(Vec3d(0, 0, 0.01 * s)), Vec3d::Zero()}});
  }
  const auto error = relativeError(truth, estimate, 1.0);
  ASSERT_TRUE(error.has_value());
  EXPECT_NEAR(error->rot_deg, 0.5729577951308232, 1e-9);
  EXPECT_NEAR(error->trans_m, 0.0, 1e-12);
}

TEST(RelativeError, NeedsASecond) {
  const Trajectory truth = smoothPath(0, 50 * kMs, 10);
  EXPECT_FALSE(relativeError(truth, truth, 1.0).has_value());
}

TEST(Evaluate, AppliesTheBodysLeverArmToTheTruth) {
  const Trajectory cam = smoothPath(0, 50 * kMs, 100);
  const SE3d T_body_cam = SE3d::exp((Vec6d() << 0.3, -0.2, 0.1, 0.5, -1.0, 0.2).finished());
  const GroundTruth truth{inFrame(cam, T_body_cam.inverse()), RigFrame::body};
  const Trajectory estimate = estimateOf(cam, 0.0, 1);
  const auto with =
      evaluate(truthInFrame(truth, RigFrame::camera, T_body_cam), {estimate, estimate, estimate});
  EXPECT_EQ(with.matched, 100);
  EXPECT_LT(with.final_error->rmse_m, 1e-9);
  EXPECT_LT(with.relative_error->trans_m, 1e-9);
  const auto without = evaluate(truth.poses, {estimate, estimate, estimate});
  EXPECT_GT(without.final_error->rmse_m, 0.01);
}

TEST(Evaluate, WritesTheBodysTrajectoryInTheEstimatesUnit) {
  const Trajectory cam = smoothPath(0, 50 * kMs, 100);
  const SE3d T_body_cam = SE3d::exp((Vec6d() << 0.3, -0.2, 0.1, 0.5, -1.0, 0.2).finished());
  const Trajectory truth_body = inFrame(cam, T_body_cam.inverse());
  const Trajectory estimate = estimateOf(cam, 0.0, 1);
  const Estimates body = toBody({estimate, estimate, {}}, T_body_cam, 1.0 / 0.37);
  EXPECT_LT(absoluteError(truth_body, body.recomposed)->rmse_m, 1e-9);
  EXPECT_FALSE(evaluate(truth_body, body).keyframe_error.has_value());
}

}  // namespace
}  // namespace glide::replay
