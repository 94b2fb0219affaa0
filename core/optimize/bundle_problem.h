#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <atomic>
#include <vector>

namespace glide {

/// Reprojection of point `point` into camera `camera`.
struct BundleObservation {
  int camera = 0;
  int point = 0;
  Vec2d uv;
  double inv_sigma = 1.0;  ///< 1 / px, 1 / (scale of the feature's level)
  bool inlier = true;      ///< in: use it; out: within the chi2 gate after the solve
};

/// Bundle adjustment over plain arrays: solved in place.
struct BundleProblem {
  struct Camera {
    SE3d T_cam_world;
    bool fixed = false;
  };
  std::vector<Camera> cameras;
  std::vector<Vec3d> points;
  std::vector<BundleObservation> observations;
};

/// Trust region to start from: nearly Gauss-Newton, since maps are close to their optimum.
inline constexpr double kInitialTrustRegion = 1e4;

struct BundleOptions {
  int max_iterations = 10;
  int rounds = 2;  ///< outliers (chi2 5.991) leave between rounds; Huber in all but the last
  double trust_region_radius = kInitialTrustRegion;  ///< more for long maps, which bend easily
  const std::atomic<bool>* cancel = nullptr;         ///< may be null; checked once per iteration
};

struct BundleSummary {
  double initial_cost = 0.0, final_cost = 0.0;
  int iterations = 0;
  int outliers = 0;
  bool usable = false;     ///< false: nothing was changed
  bool cancelled = false;  ///< poses and points are a valid intermediate state
};

/// Minimises the robust reprojection error with Ceres (analytic Jacobians, Schur complement, one
/// thread).
BundleSummary solveBundle(const CameraModel& camera,
                          const BundleOptions& options,
                          BundleProblem* problem);

}  // namespace glide
