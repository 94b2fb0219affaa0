#pragma once

#include "photometric/level_evaluator.h"

#include "image/pyramid.h"

#include <span>
#include <vector>

namespace glide {

/// How well each point of a reference agrees with a frame at a pose that some aligner found, at the
/// finest level. Keeps patches of its own, on the CPU: nothing comes back from a GPU for it. One
/// owner, one thread.
class PointResiduals {
 public:
  /// For frames of the camera; the config is valid.
  PointResiduals(const Config::Direct& config, const CameraModel& camera);

  /// Makes the image the reference, with points in its camera's frame (at most
  /// Config::Direct::max_points).
  void setReference(const ImageViewU8& luma, std::span<const AlignPoint> points_ref);

  struct Residual {
    std::size_t point = 0;   ///< index into points_ref
    Vec2d uv;                ///< px in the frame
    double rms = 0.0;        ///< of the patch after the frame's gain and bias, grey levels
    bool is_inlier = false;  ///< within the Huber threshold
  };
  /// The points that both images show with their patches, in the order of points_ref. `align` is
  /// what aligning the frame to the reference gave. Valid until the next call.
  std::span<const Residual> evaluate(const ImageViewU8& luma, const AlignResult& align);

 private:
  Config::Direct config_;
  CameraModel camera_;
  PatchLayout layout_;
  LevelEvaluator evaluator_;
  ReferenceCache reference_;
  Pyramid image_;  ///< one level: of the frame or, while it is made, of the reference
  std::vector<Residual> residuals_;
};

}  // namespace glide
