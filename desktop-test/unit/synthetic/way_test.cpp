#include "synthetic/way.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::synthetic {
namespace {

constexpr double kPi = 3.141592653589793;

double lengthOf(const Way& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.x_z_yaw.size(); ++i)
    length += (way.x_z_yaw[i] - way.x_z_yaw[i - 1]).head<2>().norm();
  return length;
}

RoundTrip roundOf(double length) {
  RoundTrip trip;
  trip.corner_radius = 1.5;
  trip.half_x = 0.4 * halfSizesOfRound(length, trip.corner_radius);
  trip.half_z = 0.6 * halfSizesOfRound(length, trip.corner_radius);
  return trip;
}

TEST(Way, GoesOnceAroundAndOnOverItsBeginning) {
  const RoundTrip trip = roundOf(80.0);
  const Way way = walkAround(trip, {});
  EXPECT_NEAR(lengthOf(way), 80.0 + trip.overlap, 0.5);  // smoothing cuts the corners a little
  const Vec3d first = way.x_z_yaw.front(), last = way.x_z_yaw.back();
  EXPECT_NEAR(last.x(), first.x(), 1e-3);
  EXPECT_NEAR(last.y() - first.y(), trip.overlap, 0.1);
  EXPECT_NEAR(last.z() - first.z(), 2.0 * kPi, 1e-3);
}

TEST(Way, BendsToTheOtherSideWhenMirrored) {
  RoundTrip trip = roundOf(60.0);
  const Way way = walkAround(trip, {});
  trip.is_mirrored = true;
  const Way mirrored = walkAround(trip, {});
  ASSERT_EQ(way.x_z_yaw.size(), mirrored.x_z_yaw.size());
  const std::size_t middle = way.x_z_yaw.size() / 2;
  EXPECT_NEAR(mirrored.x_z_yaw[middle].x(), -way.x_z_yaw[middle].x(), 1e-12);
  EXPECT_NEAR(mirrored.x_z_yaw[middle].z(), -way.x_z_yaw[middle].z(), 1e-12);
}

TEST(Way, NeverExceedsItsPace) {
  const Pace pace{2.0, 0.8, 0.0};
  const Way way = walkAround(roundOf(60.0), pace);
  for (std::size_t i = 1; i < way.x_z_yaw.size(); ++i) {
    const Vec3d step = (way.x_z_yaw[i] - way.x_z_yaw[i - 1]) / way.step_s;
    EXPECT_LE(step.head<2>().norm(), pace.speed * 1.001);
    EXPECT_LE(std::abs(step.z()), pace.turn_rate * 1.001);
  }
}

TEST(Way, IsSmoothBetweenItsSamplesAndStandsStillBeyondItsEnds) {
  const Way way = walkAround(roundOf(60.0), {});
  constexpr double kStep = 0.002;            // seconds, finer than the samples
  constexpr double kMaxAcceleration = 30.0;  // m/s2 or rad/s2: no jump of velocity
  for (double t = 1.0; t < duration(way) - 1.0; t += 7.3 * kStep) {
    const Vec3d bend = wayAt(way, t + kStep) - 2.0 * wayAt(way, t) + wayAt(way, t - kStep);
    EXPECT_LT(bend.norm() / (kStep * kStep), kMaxAcceleration) << t;
  }
  EXPECT_EQ(wayAt(way, -1.0), way.x_z_yaw.front());
  EXPECT_LT((wayAt(way, duration(way) + 1.0) - way.x_z_yaw.back()).norm(), 1e-12);
}

TEST(Way, LooksWhereItIsToldToWhileWalkingStraight) {
  const Way way = walkStraight({5.0, -5.0, 2.0}, {3.0, 1.0, 0.3});
  EXPECT_NEAR(lengthOf(way), 10.0, 0.2);
  for (const Vec3d& sample : way.x_z_yaw) {
    EXPECT_NEAR(sample.y(), 2.0, 1e-9);
    EXPECT_NEAR(sample.z(), -0.5 * kPi + 0.3, 1e-9);
  }
}

}  // namespace
}  // namespace glide::synthetic
