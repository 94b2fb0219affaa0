#include "replay/render/follow_camera.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::replay {
namespace {

constexpr double kFieldOfView = 0.9;

/// A cube of landmarks of this half edge, with a camera in its middle.
Framing framingAt(const Vec3d& focus, double half) {
  Framing framing;
  framing.focus = focus;
  framing.cameras = {focus};
  for (int i = 0; i < 8; ++i) {
    framing.landmarks.push_back(focus +
                                half * Vec3d(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1));
  }
  return framing;
}

TEST(FollowCamera, HasNothingToShowBeforeTheFirstFraming) {
  EXPECT_FALSE(FollowCamera(kFieldOfView).orbit());
}

TEST(FollowCamera, TakesTheFirstFramingAsItIs) {
  FollowCamera camera(kFieldOfView);
  camera.follow(framingAt({1.0, 2.0, 3.0}, 2.0), 100.0);
  const Orbit orbit = *camera.orbit();
  EXPECT_EQ(orbit.focus, Vec3d(1.0, 2.0, 3.0));
  EXPECT_LT(eyeOf(orbit).y(), orbit.focus.y());  // above: the world's y is down
  EXPECT_LT(eyeOf(orbit).z(), orbit.focus.z());  // behind
}

TEST(FollowCamera, ApproachesAJumpWithoutOvershooting) {
  FollowCamera camera(kFieldOfView);
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  double last = 0.0;
  for (int i = 1; i <= 200; ++i) {
    camera.follow(framingAt({10.0, 0.0, 0.0}, 4.0), 0.05 * i);
    const double x = camera.orbit()->focus.x();
    EXPECT_GT(x, last);
    EXPECT_LT(x - last, 1.0);  // a tenth of the jump
    EXPECT_LT(x, 10.0);
    last = x;
  }
  EXPECT_GT(last, 9.99);
}

TEST(FollowCamera, GoesAsNearAsWhatIsToBeSeenAllows) {
  FollowCamera camera(kFieldOfView);
  Framing framing = framingAt(Vec3d::Zero(), 0.1);
  camera.follow(framing, 0.0);
  const double near = camera.orbit()->distance;
  framing.cameras.push_back({3.0, 0.0, 0.0});  // every camera is to be seen
  camera.jump();
  camera.follow(framing, 0.1);
  EXPECT_GT(camera.orbit()->distance, 5.0 * near);
  framing.cameras.pop_back();
  for (int i = 0; i < 100; ++i) framing.landmarks.push_back({0.01 * i, 0.0, 0.0});
  framing.landmarks.push_back({50.0, 0.0, 0.0});  // a stray landmark is not
  camera.jump();
  camera.follow(framing, 0.2);
  EXPECT_LT(camera.orbit()->distance, 5.0);
}

TEST(FollowCamera, FliesTheSameWayAtAboutAnyFrameRate) {
  FollowCamera slow(kFieldOfView), fast(kFieldOfView);
  slow.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  fast.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  const Framing next = framingAt({1.0, 0.0, 0.0}, 2.0);
  for (int i = 1; i <= 30; ++i) slow.follow(next, i / 15.0);
  for (int i = 1; i <= 120; ++i) fast.follow(next, i / 60.0);
  EXPECT_NEAR((slow.orbit()->focus - fast.orbit()->focus).norm(), 0.0, 1e-9);
  EXPECT_NEAR(slow.orbit()->distance, fast.orbit()->distance, 0.05 * fast.orbit()->distance);
}

TEST(FollowCamera, TurnsWithTheCameraButNotWhenItLooksDown) {
  FollowCamera camera(kFieldOfView);
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  Framing down = framingAt(Vec3d::Zero(), 1.0);
  down.ahead = Vec3d(0.1, 1.0, 0.0).normalized();
  for (int i = 1; i <= 100; ++i) camera.follow(down, 0.1 * i);
  EXPECT_NEAR((camera.orbit()->ahead - Vec3d::UnitZ()).norm(), 0.0, 1e-9);
  Framing right = down;
  right.ahead = Vec3d::UnitX();
  for (int i = 1; i <= 300; ++i) camera.follow(right, 10.0 + 0.1 * i);
  EXPECT_NEAR((camera.orbit()->ahead - Vec3d::UnitX()).norm(), 0.0, 1e-3);
}

TEST(FollowCamera, JumpsToAnotherMap) {
  FollowCamera camera(kFieldOfView);
  camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.0);
  camera.jump();
  camera.follow(framingAt({50.0, 0.0, 0.0}, 1.0), 0.05);
  EXPECT_EQ(camera.orbit()->focus.x(), 50.0);
}

TEST(FollowCamera, SwingsToBothSides) {
  FollowCamera camera(kFieldOfView);
  double least = 0.0, most = 0.0;
  for (int i = 0; i <= 400; ++i) {
    camera.follow(framingAt(Vec3d::Zero(), 1.0), 0.05 * i);
    least = std::min(least, camera.orbit()->azimuth);
    most = std::max(most, camera.orbit()->azimuth);
  }
  EXPECT_LT(least, -0.3);
  EXPECT_GT(most, 0.3);
}

}  // namespace
}  // namespace glide::replay
