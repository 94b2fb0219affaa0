#pragma once

#include "geometry/eigen_types.h"
#include "geometry/lie.h"

#include <array>

namespace glide {

inline constexpr int kMaxAlignLevels = 8;

/// A point of the reference, in the reference camera's frame.
struct AlignPoint {
  Vec3d p_ref;
};

/// Outcome of aligning one frame to the reference (ALGORITHMS section 3).
struct AlignResult {
  SE3d T_cam_ref;
  /// Information of the pose at the finest level, in units of grey levels squared: sum of w J^T J,
  /// for right perturbations T_cam_ref * exp(-delta), twist (translation, rotation).
  Mat6d H = Mat6d::Zero();
  double rms = 0.0;  ///< robust mean of the patch RMS errors at the finest level, grey levels
  double contrast =
      0.0;  ///< mean standard deviation of the reference patches that are visible, grey levels
  double gain = 1.0, bias = 0.0;  ///< I_frame = gain * I_ref + bias
  int points = 0;                 ///< points of the reference that are valid at the finest level
  int visible = 0;                ///< of these, the ones inside the frame
  int inliers = 0;                ///< of these, the ones within the Huber threshold
  std::array<int, kMaxAlignLevels> iterations{};
  /// Every level that was solved had enough points, a positive definite system and a finite pose.
  bool valid = false;
};

/// Milliseconds of the last loadFrame / promoteReference / align.
struct AlignTimes {
  double pyramid_ms = 0.0, precompute_ms = 0.0, align_ms = 0.0;
};

}  // namespace glide
