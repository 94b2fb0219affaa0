#include "mapping/initial_map.h"

#include "support/mapped_scene.h"

#include "mapping/new_landmarks.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

#include <random>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::walk;

TEST(InitialMap, IsScaledToTheConfiguredMedianDepth) {
  MappedScene scene(smallCloud(), {});
  scene.start();
  EXPECT_NEAR(medianDepth(scene.state.map, scene.state.map.keyframes().begin()->second), 1.0, 1e-9);
  EXPECT_LT(scene.landmarkError(), 1e-3);
  EXPECT_EQ(checkConsistency(scene.state.map), "");
}

TEST(InitialMap, KeepsTheFirstCameraWhereItIs) {
  MappedScene scene(smallCloud(), {});
  InitialMap message = scene.tracker.start(&scene.cloud, walk(0), walk(1), 2.0);
  const SE3d T_old_new{so3Exp(Vec3d(0.1, 0.2, 0.3)), Vec3d(1.0, 2.0, 3.0)};  // another world frame
  message.a.T_cam_world = message.a.T_cam_world * T_old_new;
  message.b.T_cam_world = message.b.T_cam_world * T_old_new;
  for (InitialMap::Point& point : message.points) {
    point.p_world = T_old_new.inverse() * point.p_world;
  }
  ASSERT_TRUE(startMap(&scene.state, message));
  const SE3d& T_cam_world = scene.state.map.keyframe(message.a.id)->T_cam_world;
  EXPECT_LT(test::translationError(T_cam_world, message.a.T_cam_world), 1e-9);
  EXPECT_LT(scene.landmarkError(), 1e-3);
}

TEST(InitialMap, DropsPointsThatDoNotFit) {
  MappedScene scene(smallCloud(), {});
  InitialMap message = scene.tracker.start(&scene.cloud, walk(0), walk(2), 2.0);
  const std::size_t all = message.points.size();
  for (std::size_t i = 0; i + 10 < all; i += 10) {  // every tenth: the match of another point
    std::swap(message.points[i].feature_b, message.points[i + 5].feature_b);
  }
  ASSERT_TRUE(startMap(&scene.state, message));
  EXPECT_LT(scene.state.map.landmarkCount(), all * 85 / 100);
  EXPECT_GT(scene.state.map.landmarkCount(), all * 70 / 100);
  EXPECT_LT(scene.landmarkError(), 0.02);  // mismatches along their epipolar line remain
  EXPECT_EQ(checkConsistency(scene.state.map), "");
}

TEST(InitialMap, RefusesAPairThatIsNoGeometry) {
  MappedScene scene(smallCloud(), {});
  InitialMap message = scene.tracker.start(&scene.cloud, walk(0), walk(2), 2.0);
  std::mt19937_64 random(5);
  std::shuffle(message.points.begin(), message.points.end(), random);
  std::vector<int> features_b;
  for (const InitialMap::Point& point : message.points) features_b.push_back(point.feature_b);
  std::shuffle(features_b.begin(), features_b.end(), random);
  for (std::size_t i = 0; i < features_b.size(); ++i) message.points[i].feature_b = features_b[i];
  EXPECT_FALSE(startMap(&scene.state, message));
  EXPECT_TRUE(scene.state.map.keyframes().empty());
  EXPECT_EQ(scene.state.map.landmarkCount(), 0U);
}

TEST(InitialMap, ReplacesTheOldMapAndGoesOnCountingLandmarks) {
  MappedScene scene(smallCloud(), {});
  scene.start();
  const LandmarkId last_old = scene.state.map.landmarkIds().back();
  const KeyframeId first_old = scene.state.map.keyframes().begin()->first;
  scene.start();
  EXPECT_EQ(scene.state.map.keyframes().size(), 2U);
  EXPECT_FALSE(scene.state.map.T_cam_world(first_old).has_value());
  EXPECT_LT(last_old, scene.state.map.landmarkIds().front());
}

}  // namespace
}  // namespace glide
