#include "geometry/two_view.h"

#include "unit/geometry/two_view_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glide {
namespace {

using test::Scene;
using test::SceneOptions;
using test::SceneShape;

constexpr double kDegPerRad = 57.29577951308232;

/// Rotation and direction of the translation within the given degrees of the truth.
void expectPose(const TwoViewResult& result,
                const Scene& scene,
                double rotation_deg,
                double direction_deg) {
  ASSERT_EQ(result.status, InitializationStatus::done);
  EXPECT_LT(test::rotationError(result.T_b_a, scene.T_b_a) * kDegPerRad, rotation_deg);
  EXPECT_LT(test::directionError(result.T_b_a, scene.T_b_a) * kDegPerRad, direction_deg);
  EXPECT_NEAR(result.T_b_a.t.norm(), 1.0, 1e-12);
}

class TwoView : public ::testing::TestWithParam<bool> {
 protected:
  static CameraModel camera() { return GetParam() ? test::fisheye() : test::euroc(); }
  static TwoViewResult solve(const Scene& scene) { return solveTwoView(camera(), scene.pairs, {}); }
};
INSTANTIATE_TEST_SUITE_P(Geometry, TwoView, ::testing::Bool(), [](const auto& suite) {
  return std::string(suite.param ? "fisheye" : "euroc");
});

TEST_P(TwoView, RecoversAGeneralSceneExactlyWithoutNoise) {
  const Scene scene = test::makeScene(camera(), {});
  const TwoViewResult result = solve(scene);
  expectPose(result, scene, 1e-6, 1e-5);
  EXPECT_FALSE(result.from_homography);
  EXPECT_EQ(result.inliers, 300);
  EXPECT_GT(result.landmarks, 290);
  const double scale = 1.0 / scene.T_b_a.t.norm();
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    if (!result.triangulated[i]) continue;
    EXPECT_LT((result.points_a[i] - scale * scene.points_a[i]).norm(), 1e-4);
  }
}

TEST_P(TwoView, RecoversAPlanarSceneExactlyWithoutNoise) {
  SceneOptions options;
  options.shape = SceneShape::plane;
  const Scene scene = test::makeScene(camera(), options);
  const TwoViewResult result = solve(scene);
  expectPose(result, scene, 1e-4, 1e-3);
  EXPECT_TRUE(result.from_homography);
}

TEST_P(TwoView, WithstandsNoiseAndOutliers) {
  SceneOptions options;
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  for (options.seed = 1; options.seed <= 5; ++options.seed) {
    const Scene scene = test::makeScene(camera(), options);
    const TwoViewResult result = solve(scene);
    expectPose(result, scene, 0.4, 3.0);
    int wrong = 0;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
      wrong += scene.outlier[i] && result.triangulated[i] ? 1 : 0;
    }
    EXPECT_LE(wrong, 10);  // those that fell next to their epipolar line
  }
}

TEST_P(TwoView, WithstandsNoiseAndOutliersOnAPlane) {
  SceneOptions options;
  options.shape = SceneShape::plane;
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  options.T_b_a.t *= 2.0;
  for (options.seed = 1; options.seed <= 5; ++options.seed) {
    const Scene scene = test::makeScene(camera(), options);
    expectPose(solve(scene), scene, 0.5, 3.0);
  }
}

TEST_P(TwoView, FollowsForwardMotion) {
  SceneOptions options;
  options.T_b_a = SE3d{so3Exp(Vec3d(0.01, 0.02, 0.03)), Vec3d(0.02, 0.03, 0.5)};
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  const Scene scene = test::makeScene(camera(), options);
  expectPose(solve(scene), scene, 0.4, 3.0);
}

TEST_P(TwoView, RefusesPureRotation) {
  SceneOptions options;
  options.T_b_a.t.setZero();
  options.noise_px = 0.5;
  options.outlier_share = 0.2;
  for (const SceneShape shape : {SceneShape::box, SceneShape::plane}) {
    options.shape = shape;
    const TwoViewResult result = solve(test::makeScene(camera(), options));
    EXPECT_EQ(result.status, InitializationStatus::pure_rotation);
    EXPECT_GT(result.parallax_deg, 0.0);
    EXPECT_LT(result.parallax_deg, 0.6);
    EXPECT_EQ(result.landmarks, 0);
  }
}

TEST_P(TwoView, RefusesACameraAtRest) {
  SceneOptions options;
  options.T_b_a = SE3d{};
  options.noise_px = 0.5;
  EXPECT_EQ(solve(test::makeScene(camera(), options)).status,
            InitializationStatus::too_little_motion);
}

TEST_P(TwoView, NeverStartsAWrongMapAtAnyBaseline) {
  SceneOptions options;
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  const Vec3d t = options.T_b_a.t;
  for (const double scale : {0.02, 0.05, 0.1, 0.15, 0.25, 0.5}) {
    for (const SceneShape shape : {SceneShape::box, SceneShape::plane}) {
      options.T_b_a.t = scale * t;
      options.shape = shape;
      ++options.seed;
      const Scene scene = test::makeScene(camera(), options);
      const TwoViewResult result = solve(scene);
      if (result.status == InitializationStatus::done) expectPose(result, scene, 0.5, 10.0);
      EXPECT_TRUE(scale > 0.1 || result.status != InitializationStatus::done);
    }
  }
}

TEST_P(TwoView, RefusesAPlaneSeenWithTwoExplanations) {
  SceneOptions options;
  options.shape = SceneShape::plane;
  options.T_b_a = SE3d{so3Exp(Vec3d(0.01, 0.1, 0.03)), Vec3d(-0.3, 0.03, 0.3)};
  options.noise_px = 0.5;
  EXPECT_EQ(solve(test::makeScene(camera(), options)).status, InitializationStatus::ambiguous);
}

TEST_P(TwoView, RefusesTooFewMatchesAndWrongOnes) {
  SceneOptions options;
  options.pairs = 49;
  const TwoViewResult few = solve(test::makeScene(camera(), options));
  EXPECT_EQ(few.status, InitializationStatus::too_few_matches);
  EXPECT_EQ(few.parallax_deg, 0.0);
  EXPECT_EQ(few.points_a.size(), 49U);
  options.pairs = 200;
  options.outlier_share = 1.0;
  EXPECT_NE(solve(test::makeScene(camera(), options)).status, InitializationStatus::done);
  EXPECT_EQ(solve(Scene{}).status, InitializationStatus::too_few_matches);
}

TEST_P(TwoView, GivesTheSameAnswerTwice) {
  SceneOptions options;
  options.noise_px = 0.5;
  options.outlier_share = 0.3;
  const Scene scene = test::makeScene(camera(), options);
  const TwoViewResult first = solve(scene);
  const TwoViewResult second = solve(scene);
  EXPECT_EQ(first.T_b_a.matrix(), second.T_b_a.matrix());
  EXPECT_EQ(first.triangulated, second.triangulated);
}

TEST_P(TwoView, ReportsTheParallaxItFound) {
  const Scene scene = test::makeScene(camera(), {});
  const TwoViewResult result = solve(scene);
  std::vector<double> angles;
  for (const Vec3d& p : scene.points_a) {
    angles.push_back(
        std::acos((scene.T_b_a.q * p).normalized().dot((scene.T_b_a * p).normalized())));
  }
  std::sort(angles.rbegin(), angles.rend());
  EXPECT_NEAR(result.parallax_deg, angles[50] * kDegPerRad, 0.01);  // min_points
}

}  // namespace
}  // namespace glide
