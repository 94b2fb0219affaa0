#include "replay/render/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glide::replay {
namespace {

Pose poseOf(const SE3d& T) {
  return {{T.t.x(), T.t.y(), T.t.z()}, {T.q.x(), T.q.y(), T.q.z(), T.q.w()}};
}

void addKeyframe(MapView& map, const SE3d& T_world_cam) {
  MapView::Keyframe key;
  key.id = map.keyframes.size();
  key.T_world_cam = poseOf(T_world_cam);
  map.keyframes.push_back(key);
}

/// Landmarks in a ball.
void addBall(MapView& map, const Vec3d& center, double radius, int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  while (count > 0) {
    const Vec3d p(uniform(random), uniform(random), uniform(random));
    if (p.norm() > 1.0) continue;
    const Vec3d p_world = center + radius * p;
    map.landmarks.push_back({map.landmarks.size(), {p_world.x(), p_world.y(), p_world.z()}, 3});
    --count;
  }
}

TEST(Framing, HoldsTheCameraAndWhatLiesBeforeIt) {
  MapView map;
  addKeyframe(map, {});
  addBall(map, {0.0, 0.0, 5.0}, 1.0, 500);
  const auto framing = frameAround(map, SE3d());
  ASSERT_TRUE(framing);
  EXPECT_NEAR((framing->focus - Vec3d(0.0, 0.0, 3.25)).norm(), 0.0, 0.1);
  EXPECT_EQ(framing->landmarks.size(), 500U);
  EXPECT_EQ(framing->cameras.size(), 2U);
  EXPECT_NEAR((framing->ahead - Vec3d::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(Framing, LeavesOutWhatLiesElsewhereOrFarAway) {
  MapView map;
  addKeyframe(map, {});
  addBall(map, {0.0, 0.0, 5.0}, 1.0, 500);
  addBall(map, {0.0, 0.0, -50.0}, 1.0, 500);  // behind
  addBall(map, {0.0, 0.0, 80.0}, 5.0, 100);   // the horizon
  addKeyframe(map, {Eigen::Quaterniond::Identity(), Vec3d(0.0, 0.0, -70.0)});
  const auto framing = frameAround(map, SE3d());
  ASSERT_TRUE(framing);
  EXPECT_EQ(framing->landmarks.size(), 500U);
  EXPECT_EQ(framing->cameras.size(), 2U);
}

TEST(Framing, IsNothingWithoutLandmarksBeforeTheCamera) {
  MapView map;
  addKeyframe(map, {});
  EXPECT_FALSE(frameAround(map, SE3d()));
  addBall(map, {0.0, 0.0, -5.0}, 1.0, 10);
  EXPECT_FALSE(frameAround(map, SE3d()));
}

TEST(Framing, FindsUpOfATiltedCameraThatTurns) {
  const Vec3d down = Vec3d(0.2, 0.8, 0.5).normalized();  // gravity in the first camera, tilted
  // Without roll: x axes at right angles to gravity.
  const Vec3d right = down.cross(Vec3d(0.1, 0.0, 1.0)).normalized();
  const Vec3d ahead = right.cross(down);
  MapView map;
  for (int i = 0; i < 20; ++i) {
    const double yaw = 0.08 * i, pitch = 0.5;
    const Vec3d x = std::cos(yaw) * right + std::sin(yaw) * ahead;
    const Vec3d level_z = x.cross(down);
    const Vec3d z = std::cos(pitch) * level_z + std::sin(pitch) * down;
    Mat3d R_world_cam;
    R_world_cam << x, z.cross(x), z;
    addKeyframe(map, {Eigen::Quaterniond(R_world_cam), Vec3d::Zero()});
  }
  EXPECT_LT(std::acos(upOf(map).dot(-down)), 0.1);
  MapView first;
  first.keyframes = {map.keyframes.front()};
  EXPECT_LT(std::acos(upOf(first).dot(-down)), 0.6);  // no better than how the camera is held
}

TEST(Framing, TakesTheFirstCamerasUpWithoutKeyframes) {
  EXPECT_NEAR((upOf(MapView()) + Vec3d::UnitY()).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace glide::replay
