#include "synthetic/trajectory.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kFade = 0.5;  // seconds in which the camera comes to rest and starts again

double wave(double t_s, double period_s) { return std::sin(kTwoPi * t_s / period_s); }

/// Camera at `eye` that looks at `target`, upright (the world's y points down).
SE3d lookAt(const Vec3d& eye, const Vec3d& target) {
  const Vec3d z_world = (target - eye).normalized();
  const Vec3d x_world = Vec3d::UnitY().cross(z_world).normalized();
  Mat3d R_world_cam;
  R_world_cam << x_world, z_world.cross(x_world), z_world;
  return {Eigen::Quaterniond(R_world_cam), eye};
}

/// A turn by yaw, pitch and roll (radians) after a move (metres), in the camera's axes.
SE3d moveAndTurn(const Vec3d& move, const Vec3d& yaw_pitch_roll) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(yaw_pitch_roll.x(), Vec3d::UnitY()) *
                               Eigen::AngleAxisd(yaw_pitch_roll.y(), Vec3d::UnitX()) *
                               Eigen::AngleAxisd(yaw_pitch_roll.z(), Vec3d::UnitZ());
  return {q, move};
}

// Below: shares of the scene's depth, periods in seconds, angles in radians. At 1.5 m depth and 30
// frames/s the handheld camera moves up to 17 mm a frame, as fast as the fast part of EuRoC MH01.
SE3d handheld(double t, double depth) {
  const Vec3d move(0.40 * wave(t, 8.0),
                   0.10 * wave(t, 5.3) - 0.02 * wave(t, 1.7),
                   0.12 * (wave(t + 2.0, 8.0) - 1.0));
  const Vec3d tremor(0.012 * wave(t, 1.1), 0.009 * wave(t, 0.83), 0.008 * wave(t, 1.37));
  const Vec3d turn(-0.25 * wave(t, 8.0), 0.06 * wave(t, 5.3), 0.05 * wave(t, 6.1));
  return moveAndTurn(depth * move, turn + tremor);
}

SE3d sweep(double t, double depth) {
  const Vec3d move(0.8 * wave(t, 14.0), 0.05 * wave(t, 4.1), 0.0);
  return moveAndTurn(depth * move, {0.03 * wave(t, 3.1), 0.02 * wave(t, 2.7), 0.02 * wave(t, 5.0)});
}

SE3d corridor(double t, double depth) {
  const Vec3d move(0.08 * wave(t, 3.1), 0.03 * wave(t, 1.9), 0.5 * wave(t, 12.0));
  return moveAndTurn(depth * move, {0.05 * wave(t, 4.3), 0.02 * wave(t, 2.3), 0.0});
}

SE3d rotation(double t) {
  return moveAndTurn(Vec3d::Zero(), {0.4 * wave(t, 6.0), 0.12 * wave(t, 4.0), 0.0});
}

SE3d orbit(double t, const Viewpoint& viewpoint) {
  constexpr double kPeriod = 20.0;  // seconds a round, or there and back
  const bool is_round = viewpoint.orbit_arc > 6.0;
  const double angle =
      is_round ? kTwoPi * t / kPeriod : 0.5 * viewpoint.orbit_arc * wave(t, kPeriod);
  const double radius =
      viewpoint.orbit_radius * (1.0 + 0.05 * wave(t, 33.1));  // no two rounds alike
  const double height = viewpoint.orbit_rise * viewpoint.orbit_radius * (1.0 + 0.15 * wave(t, 7.0));
  const Vec3d offset(radius * std::sin(angle), -height, -radius * std::cos(angle));
  return lookAt(viewpoint.orbit_center + offset, viewpoint.orbit_center);
}

SE3d walk(double t, const Viewpoint& viewpoint) {
  const Vec3d x_z_yaw = wayAt(viewpoint.way, t);
  const SE3d T_world_path = {Eigen::Quaterniond(Eigen::AngleAxisd(x_z_yaw.z(), Vec3d::UnitY())),
                             Vec3d(x_z_yaw.x(), viewpoint.eye.y(), x_z_yaw.y())};
  const Vec3d sway(0.05 * wave(t, 3.7), 0.03 * wave(t, 1.9), 0.0);  // metres
  const Vec3d turn(0.04 * wave(t, 4.3), 0.02 * wave(t, 2.3), 0.015 * wave(t, 3.1));
  return T_world_path * moveAndTurn(sway, turn);
}

/// Runs like t, but stands still in the pause; slows down and speeds up over kFade.
double pausedTime(const Motion& motion, double t) {
  const double length = motion.pause_end_s - motion.pause_begin_s;
  if (length <= 0.0 || t <= motion.pause_begin_s - kFade) return t;
  const auto ramp = [](double x) {
    return x * x / (2.0 * kFade);
  };  // integral of a velocity that falls to zero
  const double rest =
      motion.pause_begin_s - 0.5 * kFade;  // the time that shows on the stopped clock
  if (t < motion.pause_begin_s) return rest - ramp(motion.pause_begin_s - t);
  if (t < motion.pause_end_s) return rest;
  if (t < motion.pause_end_s + kFade) return rest + ramp(t - motion.pause_end_s);
  return rest + 0.5 * kFade + (t - motion.pause_end_s - kFade);
}

SE3d moved(const Motion& motion, const Viewpoint& viewpoint, double t) {
  const SE3d T_world_start = lookAt(viewpoint.eye, viewpoint.target);
  switch (motion.kind) {
    case MotionKind::handheld:
      return T_world_start * handheld(t, viewpoint.depth);
    case MotionKind::sweep:
      return T_world_start * sweep(t, viewpoint.depth);
    case MotionKind::corridor:
      return T_world_start * corridor(t, viewpoint.depth);
    case MotionKind::walk:
      return walk(t, viewpoint);
    case MotionKind::rotation:
      return T_world_start * rotation(t);
    case MotionKind::orbit:
      return orbit(t, viewpoint);
    case MotionKind::still:
      return T_world_start;
  }
  return T_world_start;
}

}  // namespace

SE3d poseAt(const Motion& motion, const Viewpoint& viewpoint, double t_s) {
  if (motion.turn_first_s > 0.0 && t_s < motion.turn_first_s) {
    // A yaw that leaves and returns with zero velocity: 1 - cos.
    const double yaw = 0.2 * (1.0 - std::cos(kTwoPi * t_s / motion.turn_first_s));
    return moved(motion, viewpoint, 0.0) * moveAndTurn(Vec3d::Zero(), {yaw, 0.0, 0.0});
  }
  return moved(motion, viewpoint, motion.speed * pausedTime(motion, t_s - motion.turn_first_s));
}

}  // namespace glide::synthetic
