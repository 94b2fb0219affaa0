#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace glide {

/// A point known in the frames of two cameras, each with its own unit of length, and seen by both.
struct Sim3Pair {
  Vec3d p_a, p_b;
  Vec2d uv_a, uv_b;                             ///< distorted pixels
  double inv_sigma_a = 1.0, inv_sigma_b = 1.0;  ///< 1 / px
};

/// Standard deviation of the logarithm of a landmark's distance. Two cameras at one place see the
/// same whatever the scale between them: only how far the landmarks are tells it.
inline constexpr double kLogDepthSigma = 0.15;

/// The largest of three squared errors, in sigma^2: p_b seen by a, p_a seen by b, and the
/// logarithm of the ratio of their distances from a. Infinite when a point does not project.
double pairError2(const CameraModel& camera, const Sim3d& S_a_b, const Sim3Pair& pair);

struct Sim3RansacOptions {
  double max_error2 = 9.21;  ///< sigma^2 of each of the errors; 99 % of chi-squared
  int iterations = 300;
  int min_inliers = 15;
  std::uint64_t seed = 1;
};

struct Sim3RansacResult {
  Sim3d S_a_b;
  std::vector<bool> inlier;
  int inliers = 0;
};

/// Similarity between two frames from three pairs of points (Horn 1987, Umeyama 1991) inside RANSAC
/// with MSAC's score over both images and an early stop, fitted again to the inliers' points;
/// nothing when fewer than min_inliers agree with any.
std::optional<Sim3RansacResult> solveSim3(const CameraModel& camera,
                                          std::span<const Sim3Pair> pairs,
                                          const Sim3RansacOptions& options);

}  // namespace glide
