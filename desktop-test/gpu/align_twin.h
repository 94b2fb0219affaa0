#pragma once

#include "gpu/align_layout.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "image/image.h"

#include "glide/config.h"

#include <optional>
#include <vector>

namespace glide::test {

/// The scalar twin of the alignment kernels: docs/algorithms/photometric-alignment.md in double,
/// one formula after the other, with the 1x6 Jacobian of every pixel spelled out. Slow on purpose.
struct TwinPoint {
  bool valid = false;
  Vec3d p_ref = Vec3d::Zero();
  double m0 = 0.0, E = 0.0, Ex = 0.0, Ey = 0.0, Gx = 0.0, Gy = 0.0, Gxx = 0.0, Gxy = 0.0, Gyy = 0.0;
  Vec6d Jx = Vec6d::Zero(), Jy = Vec6d::Zero();
  std::vector<Vec3d> pixels;  ///< e, gx, gy
};

struct TwinSums {
  bool visible = false;
  double s1 = 0.0, s2 = 0.0, sc = 0.0, sx = 0.0, sy = 0.0;
};

/// What the iterations carry.
struct TwinState {
  SE3d T_cam_ref;
  std::vector<double> weights;
  double gain = 1.0, bias = 0.0, rms = 0.0, contrast = 0.0;
  int visible = 0, inliers = 0;
  Mat6d H = Mat6d::Zero();
  Vec6d delta = Vec6d::Zero();
};

/// Bilinear sample; the four texels lie inside.
double sampleTwin(const ImageF& image, double u, double v);

/// Precompute of one point. `camera` is the level's.
TwinPoint describeTwin(const ImageF& level_image,
                       const CameraModel& camera,
                       const Vec3d& p_ref,
                       int patch_size);

/// Residual sums of one point.
TwinSums sumTwin(const ImageF& level_image,
                 const CameraModel& camera,
                 const SE3d& T_cam_ref,
                 const TwinPoint& point);

/// Steps 1 to 7 of one iteration. False when the system is not positive definite.
bool solveTwin(const std::vector<TwinPoint>& points,
               const std::vector<TwinSums>& sums,
               const Config::Direct& direct,
               TwinState* state);

/// The record and the sums as the kernels lay them out.
GpuPointRecord packRecord(const TwinPoint& point);
GpuPointSums packSums(const TwinSums& sums);

}  // namespace glide::test
