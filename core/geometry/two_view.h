#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "glide/types.h"

namespace glide {

/// A correspondence between two views of the same camera, distorted pixels.
struct PixelPair {
  Vec2d uv_a, uv_b;
};

struct TwoViewOptions {
  double sigma_px = 1.0;
  int min_points = 50;             ///< triangulated with parallax
  double min_parallax_deg = 1.0;   ///< of the triangulated points' median... see two_view.cpp
  int ransac_iterations = 200;
  std::uint64_t seed = 1;
};

struct TwoViewResult {
  InitializationStatus status = InitializationStatus::too_few_matches;
  bool from_homography = false;
  SE3d T_b_a;                        ///< translation of unit length; meaningful when status is done
  std::vector<Vec3d> points_a;       ///< per pair, camera a's frame; zero where not triangulated
  std::vector<bool> triangulated;    ///< per pair: inlier, in front of both, enough parallax
  int inliers = 0, landmarks = 0;
  double parallax_deg = 0.0;         ///< robust (50th largest or median) parallax of the inliers
};

/// Relative pose of two views: homography and essential matrix by RANSAC on the same samples, model selection by
/// score, decomposition, cheirality and parallax tests. Refuses ambiguous pairs (status says why).
TwoViewResult solveTwoView(const CameraModel& camera,
                           std::span<const PixelPair> pairs,
                           const TwoViewOptions& options);

}  // namespace glide
