#include "optimize/bundle_round.h"

#include "support/bundle_case.h"

#include "optimize/reprojection_cost.h"

#include <gmock/gmock.h>

namespace glide {
namespace {

class BundleRound : public testing::Test {
 protected:
  BundleState startState() const {
    BundleState state;
    for (const BundleProblem::Camera& camera : start.problem.cameras) {
      state.poses.push_back(toPoseBlock(camera.T_cam_world));
    }
    state.points = start.problem.points;
    return state;
  }
  RoundResult solve(const RoundOptions& options, BundleState* state) const {
    const std::vector<bool> use(start.problem.observations.size(), true);
    return solveRound({lens, start.problem, use}, options, state);
  }

  const CameraModel lens = test::syntheticCamera(DistortionModel::none);
  const test::BundleCase start =
      test::makeBundleCase(lens, {.cameras = 5, .points = 60, .noise_px = 0.3});
};

TEST_F(BundleRound, EndsBeforeItsFirstStepWhenTheFlagIsSet) {
  const std::atomic<bool> cancel{true};
  BundleState state = startState();
  const RoundResult result =
      solve({.trust_region_radius = kInitialTrustRegion, .cancel = &cancel}, &state);
  EXPECT_TRUE(result.cancelled);
  EXPECT_TRUE(result.usable);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(state.points, startState().points);
}

TEST_F(BundleRound, WidensTheTrustRegionAsItConverges) {
  BundleState state = startState();
  const RoundResult result = solve({.trust_region_radius = kInitialTrustRegion}, &state);
  EXPECT_TRUE(result.usable);
  EXPECT_FALSE(result.cancelled);
  EXPECT_GT(result.iterations, 0);
  EXPECT_GT(result.trust_region_radius, kInitialTrustRegion);
}

TEST_F(BundleRound, StopsAtItsLimitOfIterations) {
  BundleState state = startState();
  const RoundResult result =
      solve({.max_iterations = 1, .trust_region_radius = kInitialTrustRegion}, &state);
  EXPECT_TRUE(result.usable);
  EXPECT_EQ(result.iterations, 1);
}

TEST_F(BundleRound, SolvesMoreCamerasThanItTakesDensely) {
  test::BundleCase large =
      test::makeBundleCase(lens, {.cameras = 83, .points = 100, .max_views_per_point = 8});
  ASSERT_TRUE(solveBundle(lens, {}, &large.problem).usable);
  EXPECT_LT(test::worstCameraError(large), 1e-8);
  EXPECT_LT(test::worstPointError(large), 1e-8);
}

}  // namespace
}  // namespace glide
