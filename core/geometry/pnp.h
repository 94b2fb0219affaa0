#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace glide {

/// A world point and the distorted pixel at which it is seen.
struct PointPixel {
  Vec3d p_world;
  Vec2d uv;
};

struct PnpOptions {
  double threshold_px = 4.0;
  int iterations = 200;
  int min_inliers = 12;
  std::uint64_t seed = 1;
};

struct PnpResult {
  SE3d T_cam_world;
  std::vector<bool> inlier;
  int inliers = 0;
};

/// P3P inside RANSAC (on undistorted bearings, errors in distorted pixels) with an early stop,
/// refined on the inliers; nothing when fewer than min_inliers agree with any pose.
std::optional<PnpResult> solvePnp(const CameraModel& camera,
                                  std::span<const PointPixel> points,
                                  const PnpOptions& options);

}  // namespace glide
