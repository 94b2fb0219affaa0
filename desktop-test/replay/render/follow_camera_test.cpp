#include "replay/render/follow_camera.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::replay {
namespace {

constexpr Lens kLens{0.9, 1.0};

Framing framingAt(const Vec3d& focus, double radius) {
  Framing framing;
  framing.focus = focus;
  framing.radius = radius;
  return framing;
}

TEST(FollowCamera, HasNothingToShowBeforeTheFirstFraming) {
  EXPECT_FALSE(FollowCamera().orbit(kLens));
}

TEST(FollowCamera, TakesTheFirstFramingAsItIs) {
  FollowCamera camera;
  camera.follow(framingAt({1.0, 2.0, 3.0}, 2.0), 100.0);
  const Orbit orbit = *camera.orbit(kLens);
  EXPECT_EQ(orbit.focus, Vec3d(1.0, 2.0, 3.0));
  EXPECT_LT(eyeOf(orbit).y(), orbit.focus.y());  // above: the world's y is down
  EXPECT_LT(eyeOf(orbit).z(), orbit.focus.z());  // behind
}

TEST(FollowCamera, ApproachesAJumpWithoutOvershooting) {
  FollowCamera camera;
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  double last = 0.0;
  for (int i = 1; i <= 200; ++i) {
    camera.follow(framingAt({10.0, 0.0, 0.0}, 4.0), 0.05 * i);
    const double x = camera.orbit(kLens)->focus.x();
    EXPECT_GT(x, last);
    EXPECT_LT(x - last, 1.0);  // a tenth of the jump
    EXPECT_LT(x, 10.0);
    last = x;
  }
  EXPECT_GT(last, 9.99);
}

TEST(FollowCamera, FliesTheSameWayAtEveryFrameRate) {
  FollowCamera slow, fast;
  slow.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  fast.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  const Framing next = framingAt({1.0, 0.0, 0.0}, 2.0);
  for (int i = 1; i <= 10; ++i) slow.follow(next, 0.1 * i);
  for (int i = 1; i <= 60; ++i) fast.follow(next, i / 60.0);
  EXPECT_NEAR((eyeOf(*slow.orbit(kLens)) - eyeOf(*fast.orbit(kLens))).norm(), 0.0, 1e-9);
}

TEST(FollowCamera, TurnsWithTheCameraButNotWhenItLooksDown) {
  FollowCamera camera;
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  Framing down = framingAt(Vec3d::Zero(), 1.0);
  down.ahead = Vec3d(0.1, 1.0, 0.0).normalized();
  for (int i = 1; i <= 100; ++i) camera.follow(down, 0.1 * i);
  EXPECT_NEAR((camera.orbit(kLens)->ahead - Vec3d::UnitZ()).norm(), 0.0, 1e-9);
  Framing right = down;
  right.ahead = Vec3d::UnitX();
  for (int i = 1; i <= 300; ++i) camera.follow(right, 10.0 + 0.1 * i);
  EXPECT_NEAR((camera.orbit(kLens)->ahead - Vec3d::UnitX()).norm(), 0.0, 1e-3);
}

TEST(FollowCamera, JumpsToAnotherMap) {
  FollowCamera camera;
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  camera.jump();
  camera.follow(framingAt({50.0, 0.0, 0.0}, 1.0), 0.05);
  EXPECT_EQ(camera.orbit(kLens)->focus.x(), 50.0);
}

TEST(FollowCamera, SwingsToBothSides) {
  FollowCamera camera;
  double least = 0.0, most = 0.0;
  for (int i = 0; i <= 400; ++i) {
    camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.05 * i);
    least = std::min(least, camera.orbit(kLens)->azimuth);
    most = std::max(most, camera.orbit(kLens)->azimuth);
  }
  EXPECT_LT(least, -0.3);
  EXPECT_GT(most, 0.3);
}

}  // namespace
}  // namespace glide::replay
