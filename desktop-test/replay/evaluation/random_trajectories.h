#pragma once

#include "replay/evaluation/trajectory.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace glide::replay {

/// A smooth camera path of `count` poses, `period_ns` apart, from `start_ns`.
inline Trajectory smoothPath(std::int64_t start_ns, std::int64_t period_ns, int count) {
  Trajectory path;
  for (int i = 0; i < count; ++i) {
    const std::int64_t t_ns = start_ns + i * period_ns;
    const double s = static_cast<double>(t_ns % 1'000'000'000'000) * 1e-9;
    const Vec3d t(std::sin(0.7 * s), 0.5 * std::cos(0.4 * s), 0.3 * std::sin(1.1 * s) + 0.1 * s);
    const Vec3d omega(0.2 * std::sin(s), 0.3 * std::cos(0.5 * s), 0.1 * s);
    path.push_back({t_ns, SE3d{so3Exp(omega), t}});
  }
  return path;
}

/// The path as a monocular system would see it: another world and unit, noise of `sigma` per axis.
inline Trajectory estimateOf(const Trajectory& truth, double sigma, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sigma);
  const SE3d T_est_world = SE3d::exp((Vec6d() << 3, -1, 2, 0.4, -0.7, 1.1).finished());
  constexpr double kUnitsPerMeter = 0.37;
  Trajectory estimate;
  for (const StampedPose& pose : truth) {
    SE3d T_est_cam = T_est_world * pose.T_world_rig;
    T_est_cam.t += Vec3d{noise(random), noise(random), noise(random)};
    T_est_cam.t *= kUnitsPerMeter;
    estimate.push_back({pose.t_ns, T_est_cam});
  }
  return estimate;
}

}  // namespace glide::replay
