#include "replay/render/view_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::replay {
namespace {

/// The part of `p` to the right of the view's middle.
double rightOf(const Orbit& orbit, const Vec3d& p) {
  const Vec3d forward = orbit.focus - eyeOf(orbit);
  return forward.cross(orbit.up).normalized().dot(p - orbit.focus);
}

TEST(ViewControl, LeavesTheFlightAloneAtFirst) {
  Orbit flight;
  flight.azimuth = 0.3;
  const Orbit orbit = ViewControl().apply(flight);
  EXPECT_EQ(orbit.azimuth, flight.azimuth);
  EXPECT_EQ(orbit.distance, flight.distance);
}

TEST(ViewControl, TurnsTheSceneWithThePointer) {
  ViewControl control;
  control.drag(100.0, 0.0);
  const Orbit orbit = control.apply({});
  const Vec3d before = eyeOf(Orbit{});  // the side that faced the eye goes along to the right
  EXPECT_GT(rightOf(orbit, before), 0.1);
  control.drag(0.0, 50.0);  // down: seen from higher
  EXPECT_LT(eyeOf(control.apply({})).y(), eyeOf(orbit).y());
}

TEST(ViewControl, NeverLooksStraightDownOrUp) {
  ViewControl control;
  for (const double way : {1e5, -2e5}) {
    control.drag(0.0, way);
    EXPECT_LT(std::abs(control.apply({}).elevation), 1.57);
  }
}

TEST(ViewControl, GoesNearerAndFartherWithinLimits) {
  ViewControl control;
  control.zoom(1.0);
  EXPECT_LT(control.apply({}).distance, 1.0);
  control.zoom(-2.0);
  EXPECT_GT(control.apply({}).distance, 1.0);
  control.zoom(1e6);
  EXPECT_GT(control.apply({}).distance, 0.0);
}

TEST(ViewControl, HoldsTheViewUntilItFollowsAgain) {
  ViewControl control;
  control.drag(30.0, 10.0);
  Orbit flight;
  const Orbit shown = control.apply(flight);
  control.toggleFollow(shown);
  EXPECT_FALSE(control.isFollowing());
  flight.focus = {5.0, 0.0, 0.0};
  EXPECT_NEAR((eyeOf(control.apply(flight)) - eyeOf(shown)).norm(), 0.0, 1e-12);
  control.toggleFollow(control.apply(flight));
  EXPECT_EQ(control.apply(flight).focus, flight.focus);
}

}  // namespace
}  // namespace glide::replay
