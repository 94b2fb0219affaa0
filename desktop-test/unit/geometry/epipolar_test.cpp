// The parts of the two-view solver: minimal solver, homography, errors in pixels, refinement.
#include "unit/geometry/two_view_scene.h"

#include "geometry/epipolar_refine.h"
#include "geometry/essential.h"
#include "geometry/five_point.h"
#include "geometry/homography.h"
#include "geometry/rotation_only.h"
#include "geometry/sampling.h"
#include "geometry/triangulate.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace glide {
namespace {

using test::Scene;
using test::SceneOptions;
using test::SceneShape;

std::vector<const RayPair*> pointersTo(const std::vector<RayPair>& rays) {
  std::vector<const RayPair*> pointers;
  for (const RayPair& pair : rays) pointers.push_back(&pair);
  return pointers;
}

/// Smallest distance of an essential matrix to the true one, both of unit norm, sign aside.
double distanceToTruth(const std::vector<Mat3d>& essentials, const SE3d& T_b_a) {
  const Mat3d truth = essentialOf(T_b_a).normalized();
  double best = std::numeric_limits<double>::infinity();
  for (const Mat3d& E : essentials) {
    best = std::min({best, (E.normalized() - truth).norm(), (E.normalized() + truth).norm()});
  }
  return best;
}

TEST(FivePoint, HasTheTruthAmongItsSolutionsAlsoOnAPlane) {
  for (const SceneShape shape : {SceneShape::box, SceneShape::plane}) {
    SceneOptions options;
    options.shape = shape;
    options.pairs = 200;
    const Scene scene = test::makeScene(test::euroc(), options);
    const std::vector<RayPair> rays = makeRayPairs(test::euroc(), scene.pairs);
    for (std::size_t i = 0; i + 5 <= rays.size(); i += 5) {
      const FivePairs sample{&rays[i], &rays[i + 1], &rays[i + 2], &rays[i + 3], &rays[i + 4]};
      EXPECT_LT(distanceToTruth(essentialsFromFivePairs(sample), scene.T_b_a), 1e-4) << i;
    }
  }
}

TEST(FivePoint, SurvivesFiveTimesTheSamePair) {
  const std::vector<RayPair> rays =
      makeRayPairs(test::euroc(), test::makeScene(test::euroc(), {}).pairs);
  for (const Mat3d& E :
       essentialsFromFivePairs({&rays[0], &rays[0], &rays[0], &rays[0], &rays[0]})) {
    EXPECT_TRUE(E.allFinite());
  }
}

TEST(Essential, HasTheTruthAmongItsFourPoses) {
  test::RandomGeometry random(3);
  for (int i = 0; i < 50; ++i) {
    SE3d T_b_a = random.transform(random.uniform(0.0, 2.5), 1.0);
    T_b_a.t.normalize();
    double best = std::numeric_limits<double>::infinity();
    for (const SE3d& pose : posesOfEssential(essentialOf(T_b_a))) {
      best = std::min(best, (pose * T_b_a.inverse()).log().norm());
    }
    EXPECT_LT(best, 1e-9);
  }
}

TEST(Essential, SampsonErrorIsInPixels) {
  // Epipolar lines of a sideways motion are rows: half of a difference in row goes to each pixel.
  const CameraModel camera =
      CameraModel::create({640, 480, 500.0, 500.0, 320.0, 240.0, DistortionModel::none, {}})
          .value();
  const SE3d T_b_a{Eigen::Quaterniond::Identity(), Vec3d(-1.0, 0.0, 0.0)};
  const std::vector<PixelPair> pairs{{Vec2d(100.0, 50.0), Vec2d(80.0, 51.0)},
                                     {Vec2d(500.0, 400.0), Vec2d(470.0, 397.0)}};
  const std::vector<RayPair> rays = makeRayPairs(camera, pairs);
  EXPECT_NEAR(sampsonSquared(essentialOf(T_b_a), rays[0]), 0.5, 1e-3);
  EXPECT_NEAR(sampsonSquared(essentialOf(T_b_a), rays[1]), 4.5, 1e-2);
}

TEST(Essential, SampsonErrorIsTheReprojectionErrorOfTheBestPoint) {
  SceneOptions options;
  options.noise_px = 1.0;
  for (const CameraModel& camera : {test::euroc(), test::fisheye()}) {
    const Scene scene = test::makeScene(camera, options);
    for (const RayPair& pair : makeRayPairs(camera, scene.pairs)) {
      const std::optional<Vec3d> p_a = triangulate(scene.T_b_a, pair.a.f, pair.b.f);
      if (!p_a) continue;
      const double error_a = (*camera.project(*p_a) - scene.pairs[pair.index].uv_a).norm();
      const double error_b =
          (*camera.project(scene.T_b_a * *p_a) - scene.pairs[pair.index].uv_b).norm();
      const double sampson = std::sqrt(sampsonSquared(essentialOf(scene.T_b_a), pair));
      EXPECT_NEAR(std::hypot(error_a, error_b), sampson, 0.1 * sampson + 0.01);
    }
  }
}

TEST(Homography, MapsAPlaneExactlyAndGivesItsMotion) {
  SceneOptions options;
  options.shape = SceneShape::plane;
  for (const CameraModel& camera : {test::euroc(), test::fisheye()}) {
    const Scene scene = test::makeScene(camera, options);
    const std::vector<RayPair> rays = makeRayPairs(camera, scene.pairs);
    const std::optional<Mat3d> H =
        fitHomography(pointersTo(rays), std::vector<double>(rays.size(), 1.0));
    ASSERT_TRUE(H);
    const Mat3d H_inverse = H->inverse();
    for (const RayPair& pair : rays) EXPECT_LT(transferSquared(*H, H_inverse, pair), 1e-12);
    double best = std::numeric_limits<double>::infinity();
    for (SE3d pose : posesOfHomography(*H)) {
      if (pose.t.dot(scene.T_b_a.t) < 0.0) pose.t = -pose.t;
      best = std::min(
          best, test::rotationError(pose, scene.T_b_a) + test::directionError(pose, scene.T_b_a));
    }
    EXPECT_LT(best, 1e-6);
  }
}

TEST(Homography, RefusesARepeatedPairAndFindsNoTranslationInARotation) {
  const std::vector<RayPair> rays =
      makeRayPairs(test::euroc(), test::makeScene(test::euroc(), {}).pairs);
  const std::vector<const RayPair*> same(5, &rays[0]);
  EXPECT_FALSE(fitHomography(same, std::vector<double>(5, 1.0)));
  EXPECT_TRUE(posesOfHomography(2.0 * so3Exp(Vec3d(0.1, 0.2, 0.3)).toRotationMatrix()).empty());
}

TEST(RotationOnly, RecoversARotationAmongOutliers) {
  SceneOptions options;
  options.T_b_a.t.setZero();
  options.outlier_share = 0.3;
  const Scene scene = test::makeScene(test::fisheye(), options);
  const std::vector<RayPair> rays = makeRayPairs(test::fisheye(), scene.pairs);
  const Eigen::Quaterniond q_b_a = fitRotation(Eigen::Quaterniond::Identity(), rays, 1.0);
  EXPECT_LT(so3Log(q_b_a * scene.T_b_a.q.conjugate()).norm(), 1e-3);
}

TEST(EpipolarRefine, JacobianIsTheDerivativeOfTheSampsonError) {
  SceneOptions options;
  options.noise_px = 5.0;  // far from zero, so that every term counts
  options.pairs = 100;
  for (const CameraModel& camera : {test::euroc(), test::fisheye()}) {
    const Scene scene = test::makeScene(camera, options);
    SE3d T_b_a = scene.T_b_a;
    T_b_a.t.normalize();
    const Mat32d basis = tangentBasis(T_b_a.t);
    for (const RayPair& pair : makeRayPairs(camera, scene.pairs)) {
      const SampsonResidual residual = sampsonResidual(T_b_a, pair);
      for (int i = 0; i < 5; ++i) {
        constexpr double kStep = 1e-6;
        const auto errorAt = [&](double step) {
          SE3d moved = T_b_a;
          if (i < 3) moved.q = so3Exp(step * Vec3d::Unit(i)) * moved.q;
          if (i >= 3) moved.t += step * basis.col(i - 3);
          return sampsonResidual(moved, pair).error;
        };
        const double numeric = (errorAt(kStep) - errorAt(-kStep)) / (2.0 * kStep);
        EXPECT_NEAR(residual.J_error_pose(i), numeric, 1e-4 * camera.fx());
      }
      EXPECT_NEAR(residual.error * residual.error, sampsonSquared(essentialOf(T_b_a), pair), 1e-9);
    }
  }
}

TEST(EpipolarRefine, ReachesOneMinimumFromManyStartsAmongOutliers) {
  SceneOptions options;
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  const Scene scene = test::makeScene(test::euroc(), options);
  const std::vector<RayPair> rays = makeRayPairs(test::euroc(), scene.pairs);
  const SE3d reference = refineEpipolar(scene.T_b_a, rays, 1.0).T_b_a;
  EXPECT_LT(test::directionError(reference, scene.T_b_a), 0.02);
  test::RandomGeometry random(4);
  for (int i = 0; i < 20; ++i) {
    SE3d start = SE3d{so3Exp(random.vector(0.005)), Vec3d::Zero()} * scene.T_b_a;
    start.t = (start.t.normalized() + random.vector(0.05)).normalized();
    const SE3d refined = refineEpipolar(start, rays, 1.0).T_b_a;
    EXPECT_LT(test::directionError(refined, reference), 1e-3) << i;
  }
}

TEST(EpipolarRefine, KnowsHowPreciseTheDirectionIs) {
  SceneOptions options;
  options.noise_px = 1.0;
  double sum2 = 0.0;
  double predicted = 0.0;
  constexpr int kRuns = 30;
  for (options.seed = 1; options.seed <= kRuns; ++options.seed) {
    const Scene scene = test::makeScene(test::euroc(), options);
    const std::vector<RayPair> rays = makeRayPairs(test::euroc(), scene.pairs);
    SE3d start = scene.T_b_a;
    start.t.normalize();
    const RefinedPose refined = refineEpipolar(start, rays, 1.0);
    sum2 += std::pow(test::directionError(refined.T_b_a, scene.T_b_a), 2.0);
    predicted += refined.direction_std / kRuns;
  }
  const double observed = std::sqrt(sum2 / kRuns);
  EXPECT_GT(predicted, 0.4 * observed);
  EXPECT_LT(predicted, 2.0 * observed);
}

TEST(Sampling, DrawsDistinctIndicesAndRepeatsUnderItsSeed) {
  std::mt19937_64 rng(7);
  std::mt19937_64 same(7);
  for (int i = 0; i < 100; ++i) {
    const std::array<std::size_t, 5> drawn = sampleDistinct<5>(6, rng);
    const std::set<std::size_t> set(drawn.begin(), drawn.end());
    EXPECT_EQ(set.size(), 5U);
    EXPECT_LT(*set.rbegin(), 6U);
    EXPECT_EQ(drawn, sampleDistinct<5>(6, same));
  }
}

TEST(Sampling, NeedsMoreSamplesForMoreOutliers) {
  EXPECT_EQ(samplesNeeded(1.0, 5), 1);
  EXPECT_NEAR(samplesNeeded(0.7, 5), 50, 1);
  EXPECT_GT(samplesNeeded(0.5, 5), 200);
  EXPECT_EQ(samplesNeeded(0.0, 5), std::numeric_limits<int>::max());
}

}  // namespace
}  // namespace glide
