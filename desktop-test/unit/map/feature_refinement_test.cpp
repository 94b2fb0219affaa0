#include "map/feature_refinement.h"

#include "support/textured_scene.h"

#include "feature/matcher.h"
#include "feature/orb_extractor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace glide {
namespace {

CameraModel makeCamera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 320;
  intrinsics.height = 240;
  intrinsics.fx = intrinsics.fy = 260.0;
  intrinsics.cx = 159.5;
  intrinsics.cy = 119.5;
  return CameraModel::create(intrinsics).value();
}

/// Two views of a textured wall with known geometry, and what a detector finds in them.
struct TwoViews {
  CameraModel camera = makeCamera();
  Config::Features config;
  ScaleLevels levels{config.scale_factor, config.levels};
  test::TexturedScene scene = test::TexturedScene::wallWithPanels();
  SE3d T_a_world, T_b_world;
  FeatureSet a, b;

  TwoViews() {
    SE3d T_world_b;
    T_world_b.t = Vec3d(0.06, -0.02, 0.03);
    T_world_b.q = so3Exp(Vec3d(0.01, -0.03, 0.05));
    T_b_world = T_world_b.inverse();
    OrbExtractor extractor(config);
    a = extractor.extract(scene.render(camera, SE3d{}, {}).view(), 500);
    b = extractor.extract(scene.render(camera, T_world_b, {}).view(), 500);
  }
};

TEST(RefineFeature, BringsMatchedCornersToWhereTheGeometrySaysTheyAre) {
  const TwoViews views;
  const MatchOptions options{50, 0.8, true};
  double before = 0.0;
  double after = 0.0;
  int count = 0;
  for (const Match& match : matchBruteForce(views.a, {}, views.b, options)) {
    const Vec2d uv_a = views.a.feature(static_cast<std::size_t>(match.a)).uv.cast<double>();
    const std::optional<Vec3d> p_world = views.scene.pointAt(views.camera, SE3d{}, uv_a);
    if (!p_world) continue;
    const Vec2d truth = views.camera.project(views.T_b_world * *p_world).value_or(Vec2d::Zero());
    const Feature& found = views.b.feature(static_cast<std::size_t>(match.b));
    const double scale = views.levels.scale(found.level);
    const double error = (found.uv.cast<double>() - truth).norm() / scale;
    if (error > 2.0) continue;  // another corner
    const std::optional<FeatureMove> move = refineFeature({&views.camera, &views.levels},
                                                          {&views.a, match.a, SE3d{}},
                                                          {&views.b, match.b, views.T_b_world},
                                                          *p_world);
    if (!move) continue;
    before += error;
    after += (move->uv.cast<double>() - truth).norm() / scale;
    ++count;
  }
  ASSERT_GT(count, 60);
  EXPECT_LT(after / count, 0.2);
  EXPECT_LT(after, 0.6 * before);
}

TEST(RefineFeature, LeavesFeaturesWithoutPatchesWhereTheyAre) {
  const TwoViews views;
  const FeatureSet bare(views.a.features(), views.a.descriptors(), 320, 240);
  const Vec3d p_world(0.0, 0.0, 1.5);
  EXPECT_FALSE(refineFeature({&views.camera, &views.levels},
                             {&bare, 0, SE3d{}},
                             {&views.b, 0, views.T_b_world},
                             p_world)
                   .has_value());
}

TEST(FeatureSet, MovesACornerTogetherWithItsPatchOffset) {
  const TwoViews views;
  const FeatureMove move{3, Vec2f(100.25F, 50.5F), Vec2f(0.5F, -0.25F)};
  const FeatureSet moved = views.a.withMoved(std::vector<FeatureMove>{move});
  EXPECT_EQ(moved.feature(3).uv, move.uv);
  EXPECT_EQ(moved.patch(3).offset, move.patch_offset);
  EXPECT_EQ(moved.feature(4).uv, views.a.feature(4).uv);
  std::vector<int> found;
  moved.query({move.uv, 0.5F, 0, 255}, &found);
  EXPECT_NE(std::find(found.begin(), found.end(), 3), found.end());
}

}  // namespace
}  // namespace glide
