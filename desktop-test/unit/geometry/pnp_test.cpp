#include "geometry/pnp.h"

#include "unit/geometry/random_geometry.h"
#include "unit/geometry/two_view_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace glide {
namespace {

constexpr double kDegPerRad = 57.29577951308232;

struct PnpScene {
  SE3d T_cam_world;
  std::vector<PointPixel> points;
  std::vector<bool> outlier;
};

struct PnpSceneOptions {
  int points = 200;
  double noise_px = 0.0;
  double outlier_share = 0.0;
};

PnpScene makePnpScene(const CameraModel& camera, const PnpSceneOptions& options) {
  test::RandomGeometry random(5);
  PnpScene scene;
  scene.T_cam_world = random.transform(2.0, 3.0);
  for (int i = 0; i < options.points; ++i) {
    const Vec2d uv = test::randomPixel(camera, random);
    const Vec3d p_cam = *camera.unproject(uv) * random.uniform(1.0, 5.0);
    const bool outlier = random.uniform(0.0, 1.0) < options.outlier_share;
    const Vec2d noise(random.gauss(options.noise_px), random.gauss(options.noise_px));
    scene.points.push_back({scene.T_cam_world.inverse() * p_cam,
                            outlier ? test::randomPixel(camera, random) : Vec2d(uv + noise)});
    scene.outlier.push_back(outlier);
  }
  return scene;
}

class PnpOnEveryCamera : public ::testing::TestWithParam<bool> {
 protected:
  static CameraModel camera() { return GetParam() ? test::fisheye() : test::euroc(); }
};
INSTANTIATE_TEST_SUITE_P(Pnp, PnpOnEveryCamera, ::testing::Bool());

TEST_P(PnpOnEveryCamera, RecoversThePoseWithoutNoise) {
  const PnpScene scene = makePnpScene(camera(), {});
  const std::optional<PnpResult> found = solvePnp(camera(), scene.points, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inliers, 200);
  EXPECT_LT((found->T_cam_world * scene.T_cam_world.inverse()).log().norm(), 1e-9);
}

TEST_P(PnpOnEveryCamera, WithstandsHalfOutliersAndNoise) {
  const PnpScene scene = makePnpScene(camera(), {300, 0.5, 0.5});
  const std::optional<PnpResult> found = solvePnp(camera(), scene.points, {});
  ASSERT_TRUE(found);
  EXPECT_LT(test::rotationError(found->T_cam_world, scene.T_cam_world) * kDegPerRad, 0.1);
  const Vec3d center = found->T_cam_world.inverse().t;
  EXPECT_LT((center - scene.T_cam_world.inverse().t).norm(), 0.01);
  int kept_outliers = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    EXPECT_TRUE(scene.outlier[i] || found->inlier[i]) << i;
    kept_outliers += scene.outlier[i] && found->inlier[i] ? 1 : 0;
  }
  EXPECT_LE(kept_outliers, 3);
}

TEST(Pnp, CountsItsInliers) {
  const PnpScene scene = makePnpScene(test::euroc(), {200, 0.5, 0.3});
  const std::optional<PnpResult> found = solvePnp(test::euroc(), scene.points, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inlier.size(), scene.points.size());
  EXPECT_EQ(found->inliers, std::count(found->inlier.begin(), found->inlier.end(), true));
}

TEST(Pnp, GivesTheSameAnswerTwice) {
  const PnpScene scene = makePnpScene(test::euroc(), {200, 0.5, 0.4});
  const std::optional<PnpResult> first = solvePnp(test::euroc(), scene.points, {});
  const std::optional<PnpResult> second = solvePnp(test::euroc(), scene.points, {});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->T_cam_world.matrix(), second->T_cam_world.matrix());
  EXPECT_EQ(first->inlier, second->inlier);
}

TEST(Pnp, RefusesWrongMatchesAndTooFewPoints) {
  const PnpScene wrong = makePnpScene(test::euroc(), {100, 0.5, 1.0});
  EXPECT_FALSE(solvePnp(test::euroc(), wrong.points, {}));
  const PnpScene few = makePnpScene(test::euroc(), {11, 0.0, 0.0});
  EXPECT_FALSE(solvePnp(test::euroc(), few.points, {}));
  EXPECT_FALSE(solvePnp(test::euroc(), {}, {}));
}

}  // namespace
}  // namespace glide
