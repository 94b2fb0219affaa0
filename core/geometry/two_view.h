#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include "glide/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glide {

/// A correspondence between two views of the same camera, distorted pixels.
struct PixelPair {
  Vec2d uv_a, uv_b;
};

struct TwoViewOptions {
  double sigma_px = 1.0;
  int min_points = 50;            ///< triangulated with parallax
  double min_parallax_deg = 1.0;  ///< see TwoViewResult::parallax_deg
  int ransac_iterations = 200;
  std::uint64_t seed = 1;
};

struct TwoViewResult {
  InitializationStatus status = InitializationStatus::too_few_matches;
  bool from_homography = false;  ///< a plane explains the pairs better than a general scene
  /// Translation of unit length; meaningful when status is done.
  SE3d T_b_a;
  std::vector<Vec3d> points_a;     ///< per pair, camera a's frame; zero where not triangulated
  std::vector<bool> triangulated;  ///< per pair: inlier, in front of both, enough parallax
  int inliers = 0, landmarks = 0;
  /// Parallax that min_points of the inliers, or half of them if that is fewer, reach; 0 when there
  /// were too few matches.
  double parallax_deg = 0.0;
};

/// Relative pose of two views: homography and essential matrix by RANSAC on the same samples, every
/// pose either suggests refined by the Sampson error of all pairs, the best one chosen by its score
/// among points in front of both cameras. Refuses pairs without translation, with too little
/// parallax and with two explanations (status says why). The same input gives the same result.
TwoViewResult solveTwoView(const CameraModel& camera,
                           std::span<const PixelPair> pairs,
                           const TwoViewOptions& options);

}  // namespace glide
