#include "optimize/bundle_problem.h"

#include "support/bundle_case.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace glide {
namespace {

using test::BundleCase;
using test::makeBundleCase;

/// Bit for bit.
bool same(const BundleProblem& a, const BundleProblem& b) {
  bool equal = a.points == b.points;
  for (std::size_t c = 0; c < a.cameras.size(); ++c) {
    equal = equal && a.cameras[c].T_cam_world.q.coeffs() == b.cameras[c].T_cam_world.q.coeffs() &&
            a.cameras[c].T_cam_world.t == b.cameras[c].T_cam_world.t;
  }
  for (std::size_t i = 0; i < a.observations.size(); ++i) {
    equal = equal && a.observations[i].inlier == b.observations[i].inlier;
  }
  return equal;
}

bool isValid(const BundleProblem& problem) {
  const auto is_finite = [](const Vec3d& p) { return p.allFinite(); };
  const auto is_rigid = [](const BundleProblem::Camera& camera) {
    const SE3d& T = camera.T_cam_world;
    return T.t.allFinite() && std::abs(T.q.norm() - 1.0) < 1e-12;
  };
  return std::all_of(problem.points.begin(), problem.points.end(), is_finite) &&
         std::all_of(problem.cameras.begin(), problem.cameras.end(), is_rigid);
}

/// Sets the flag after a while, without a sleep.
void countThenSet(int count, std::atomic<bool>* flag) {
  std::atomic<int> counter{0};
  while (counter.fetch_add(1) < count) {
  }
  flag->store(true);
}

class Bundle : public testing::TestWithParam<DistortionModel> {
 protected:
  const CameraModel lens = test::syntheticCamera(GetParam());
};

TEST_P(Bundle, RecoversCamerasAndPointsOfNoiseFreeObservations) {
  BundleCase c = makeBundleCase(lens, {.cameras = 6, .points = 100});
  const BundleSummary summary = solveBundle(lens, {.max_iterations = 15}, &c.problem);
  EXPECT_TRUE(summary.usable);
  EXPECT_EQ(summary.outliers, 0);
  EXPECT_LT(test::worstCameraError(c), 1e-9);
  EXPECT_LT(test::worstPointError(c), 1e-9);
}

TEST_P(Bundle, ToleratesOutliersAndFlagsThem) {
  BundleCase c = makeBundleCase(
      lens, {.cameras = 8, .points = 150, .noise_px = 0.3, .outlier_share = 0.2, .seed = 3});
  // The oracle never sees the outliers.
  BundleCase oracle = c;
  auto& known = oracle.problem.observations;
  for (std::size_t i = 0; i < known.size(); ++i) known[i].inlier = !c.truth.observations[i].outlier;
  ASSERT_TRUE(solveBundle(lens, {.rounds = 1}, &oracle.problem).usable);

  const BundleSummary summary = solveBundle(lens, {.rounds = 3}, &c.problem);
  ASSERT_TRUE(summary.usable);
  EXPECT_LT(test::worstCameraError(c), 1.5 * test::worstCameraError(oracle));
  int kept_outliers = 0, lost_inliers = 0, outliers = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const bool is_outlier = c.truth.observations[i].outlier;
    const bool inside = c.problem.observations[i].inlier;
    outliers += inside ? 0 : 1;
    kept_outliers += is_outlier && inside ? 1 : 0;
    lost_inliers += !is_outlier && !inside ? 1 : 0;
  }
  EXPECT_EQ(summary.outliers, outliers);
  EXPECT_EQ(kept_outliers, 0);
  // Points of which nearly half the views are wrong are beyond Huber's help.
  EXPECT_LT(lost_inliers, 0.03 * double(known.size()));
}

INSTANTIATE_TEST_SUITE_P(AllCameraModels,
                         Bundle,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

/// The remaining behaviour does not depend on the lens.
class BundleBehaviour : public testing::Test {
 protected:
  BundleCase noisyCase() const {
    return makeBundleCase(lens,
                          {.cameras = 8, .points = 150, .noise_px = 0.5, .outlier_share = 0.1});
  }
  const CameraModel lens = test::syntheticCamera(DistortionModel::radial_tangential);
};

TEST_F(BundleBehaviour, DoesNotMoveFixedCameras) {
  BundleCase c = noisyCase();
  c.problem.cameras[4].fixed = true;
  const BundleProblem before = c.problem;
  ASSERT_TRUE(solveBundle(lens, {}, &c.problem).usable);
  for (std::size_t i = 0; i < before.cameras.size(); ++i) {
    const SE3d& T_before = before.cameras[i].T_cam_world;
    const SE3d& T_after = c.problem.cameras[i].T_cam_world;
    const bool stayed = T_before.q.coeffs() == T_after.q.coeffs() && T_before.t == T_after.t;
    EXPECT_EQ(stayed, before.cameras[i].fixed) << "camera " << i;
  }
}

TEST_F(BundleBehaviour, RefinesPointsWhenAllCamerasAreFixed) {
  BundleCase c = makeBundleCase(lens, {.cameras = 5, .points = 60});
  for (std::size_t i = 0; i < c.problem.cameras.size(); ++i) {
    c.problem.cameras[i] = {c.truth.T_cam_world[i], true};
  }
  ASSERT_TRUE(solveBundle(lens, {}, &c.problem).usable);
  EXPECT_LT(test::worstPointError(c), 1e-9);
}

TEST_F(BundleBehaviour, LowersTheCostWithoutAFixedCameraToo) {
  BundleCase c = noisyCase();
  for (BundleProblem::Camera& camera : c.problem.cameras) camera.fixed = false;
  const BundleSummary summary = solveBundle(lens, {}, &c.problem);
  EXPECT_TRUE(summary.usable);
  EXPECT_LT(summary.final_cost, summary.initial_cost);
}

TEST_F(BundleBehaviour, LeavesOutWhatTheCallerFlaggedButLetsItComeBack) {
  BundleCase c = makeBundleCase(lens, {.cameras = 6, .points = 100, .noise_px = 0.2, .seed = 2});
  for (std::size_t i = 0; i < c.problem.observations.size(); i += 7) {
    c.problem.observations[i].inlier = false;
  }
  const BundleSummary summary = solveBundle(lens, {}, &c.problem);
  ASSERT_TRUE(summary.usable);
  EXPECT_EQ(summary.outliers, 0);
  EXPECT_THAT(c.problem.observations,
              testing::Each(testing::Field(&BundleObservation::inlier, true)));
}

TEST_F(BundleBehaviour, DrawsTheLineAtTheChi2GateInSigmas) {
  BundleCase c = makeBundleCase(lens, {.cameras = 8, .points = 200});
  c.problem.observations[100].uv.x() += 6.0;
  c.problem.observations[300].uv.x() += 6.0;
  c.problem.observations[300].inv_sigma = 0.3;
  const BundleSummary summary = solveBundle(lens, {}, &c.problem);
  ASSERT_TRUE(summary.usable);
  EXPECT_FALSE(c.problem.observations[100].inlier);
  EXPECT_TRUE(c.problem.observations[300].inlier);
  EXPECT_EQ(summary.outliers, 1);
}

TEST_F(BundleBehaviour, IsNotLedByAnOutlierThatTheCallerFlagged) {
  // One round without Huber: an unflagged outlier of hundreds of pixels would drag its camera
  // along.
  BundleCase c = makeBundleCase(lens, {.cameras = 6, .points = 100});
  c.problem.observations[10].uv += Vec2d(300.0, -200.0);
  c.problem.observations[10].inlier = false;
  ASSERT_TRUE(solveBundle(lens, {.max_iterations = 15, .rounds = 1}, &c.problem).usable);
  EXPECT_LT(test::worstCameraError(c), 1e-9);
  EXPECT_FALSE(c.problem.observations[10].inlier);
}

TEST_F(BundleBehaviour, KeepsThePositionOfPointsWithFewerThanTwoInliers) {
  BundleCase c = makeBundleCase(lens, {.cameras = 6, .points = 100, .noise_px = 0.2});
  int kept_views = 0;
  for (BundleObservation& o : c.problem.observations) {
    if (o.point == 3 && kept_views++ > 0)
      o.uv = Vec2d(5.0 + 90.0 * kept_views, 13.0 + 200.0 * (kept_views % 2));
    if (o.point == 4) o.inlier = false;
    if (o.point == 4) o.uv = Vec2d(1.0, 1.0);
  }
  const Vec3d p_one_inlier = c.problem.points[3];
  const Vec3d p_no_inlier = c.problem.points[4];
  ASSERT_TRUE(solveBundle(lens, {}, &c.problem).usable);
  EXPECT_EQ(c.problem.points[3], p_one_inlier);
  EXPECT_EQ(c.problem.points[4], p_no_inlier);
}

TEST_F(BundleBehaviour, IgnoresPointsBehindTheCameraAndNumbersThatAreNotFinite) {
  BundleCase c = makeBundleCase(lens, {.cameras = 6, .points = 100});
  c.problem.observations[0].uv.x() = NAN;
  const Vec3d center = c.truth.T_cam_world[5].inverse().t;
  c.problem.points.push_back(1.5 * center);
  c.truth.points.push_back(1.5 * center);
  const int behind = static_cast<int>(c.problem.points.size()) - 1;
  c.problem.observations.push_back({5, behind, Vec2d(300.0, 200.0), 1.0, true});
  c.problem.observations.push_back({4, behind, Vec2d(300.0, 200.0), 1.0, true});
  const BundleSummary summary = solveBundle(lens, {.max_iterations = 15}, &c.problem);
  ASSERT_TRUE(summary.usable);
  EXPECT_LT(test::worstCameraError(c), 1e-9);
  EXPECT_FALSE(c.problem.observations[0].inlier);
  EXPECT_FALSE(c.problem.observations.back().inlier);
}

TEST_F(BundleBehaviour, GivesTheSameBitsTwice) {
  BundleCase a = noisyCase();
  BundleCase b = a;
  const BundleSummary summary_a = solveBundle(lens, {}, &a.problem);
  const BundleSummary summary_b = solveBundle(lens, {}, &b.problem);
  EXPECT_TRUE(same(a.problem, b.problem));
  EXPECT_EQ(summary_a.final_cost, summary_b.final_cost);
}

TEST_F(BundleBehaviour, ChangesNothingWhenCancelledBeforeTheStart) {
  BundleCase c = noisyCase();
  const BundleProblem before = c.problem;
  const std::atomic<bool> cancel{true};
  const BundleSummary summary = solveBundle(lens, {.cancel = &cancel}, &c.problem);
  EXPECT_TRUE(summary.cancelled);
  EXPECT_FALSE(summary.usable);
  EXPECT_TRUE(same(before, c.problem));
}

TEST_F(BundleBehaviour, LeavesAValidStateWheneverItIsCancelled) {
  // What must hold does not depend on when the flag is set: before, in or after the solve.
  const BundleCase begin =
      makeBundleCase(lens, {.cameras = 10, .points = 300, .noise_px = 0.5, .outlier_share = 0.1});
  for (int trial = 0; trial < 12; ++trial) {
    BundleProblem problem = begin.problem;
    std::atomic<bool> cancel{false};
    std::thread canceller(countThenSet, trial * 200000, &cancel);
    const BundleSummary summary = solveBundle(lens, {.cancel = &cancel}, &problem);
    canceller.join();
    EXPECT_TRUE(summary.usable || (summary.cancelled && same(problem, begin.problem)));
    EXPECT_LE(summary.final_cost, summary.initial_cost);
    EXPECT_TRUE(isValid(problem));
  }
}

TEST_F(BundleBehaviour, IsNotUsableWithoutObservations) {
  BundleProblem empty;
  EXPECT_FALSE(solveBundle(lens, {}, &empty).usable);
  BundleCase c = noisyCase();
  c.problem.observations.clear();
  const BundleProblem before = c.problem;
  EXPECT_FALSE(solveBundle(lens, {}, &c.problem).usable);
  EXPECT_TRUE(same(before, c.problem));
}

TEST_F(BundleBehaviour, IsNotUsableWhenNoPointIsSeenTwice) {
  BundleCase c = makeBundleCase(lens, {.cameras = 4, .points = 40, .max_views_per_point = 1});
  const BundleProblem before = c.problem;
  EXPECT_FALSE(solveBundle(lens, {}, &c.problem).usable);
  EXPECT_TRUE(same(before, c.problem));
}

TEST_F(BundleBehaviour, ApproachesTheAccuracyThatTheNoiseAllows) {
  // The mean squared residual per degree of freedom tells the noise back when the optimum was
  // reached.
  constexpr double kNoisePx = 0.6;
  // What the noise leaves of the start's error; 28 draws of it left 0.07 to 0.25.
  constexpr double kRest = 0.3;
  BundleCase c = makeBundleCase(lens, {.cameras = 8, .points = 200, .noise_px = kNoisePx});
  for (BundleObservation& o : c.problem.observations) o.inv_sigma = 1.0 / kNoisePx;
  const double before = test::worstCameraError(c);
  const BundleSummary summary = solveBundle(lens, {.rounds = 1}, &c.problem);
  ASSERT_TRUE(summary.usable);
  EXPECT_LT(test::worstCameraError(c), kRest * before);
  const double freedom = 2.0 * double(c.problem.observations.size()) - 6.0 * 6.0 - 3.0 * 200.0;
  EXPECT_NEAR(test::sumOfSquares(lens, c.problem) / freedom, 1.0, 0.1);
}

}  // namespace
}  // namespace glide
