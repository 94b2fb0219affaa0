#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <span>
#include <vector>

namespace glide {

/// A landmark seen by one frame.
struct PoseObservation {
  Vec3d p_world;
  Vec2d uv;
  double inv_sigma = 1.0;  ///< 1 / px
};

struct PoseEstimate {
  SE3d T_cam_world;
  Mat6d H = Mat6d::Zero();   ///< information, left perturbation, (translation, rotation), px^-2
  std::vector<bool> inlier;  ///< per observation, chi2 < 5.991
  int inliers = 0;
  double rms_px = 0.0;  ///< of the inliers, in units of their sigma
  bool valid = false;   ///< at least 6 inliers and a finite solution
};

/// Motion-only bundle adjustment: Gauss-Newton on the 6x6 system, Huber, four rounds with chi2
/// gating in which outliers may come back; the last round is without Huber.
/// docs/algorithms/motion-only.md.
PoseEstimate optimizePose(const CameraModel& camera,
                          const SE3d& T_cam_world_guess,
                          std::span<const PoseObservation> observations);

}  // namespace glide
