#pragma once

#include "photometric/align_types.h"

#include "image/image.h"

#include "glide/config.h"

#include <span>

namespace glide {

/// The direct tracker's engine: holds the pyramid of the current frame and the cache of one
/// reference. Two implementations: CpuAligner and GpuAligner; the CPU one is the oracle of the GPU
/// one. One owner, one thread (the GL thread for the GPU).
class Aligner {
 public:
  virtual ~Aligner() = default;
  Aligner() = default;
  Aligner(const Aligner&) = delete;
  Aligner& operator=(const Aligner&) = delete;

  /// Takes a new frame: upload and pyramid. The image has the camera's size.
  virtual void loadFrame(const ImageViewU8& luma) = 0;

  /// Makes the frame loaded last the reference: its pyramid is promoted, not rebuilt, and the
  /// inverse-compositional cache is computed for `points_ref` (at most Config::Direct::max_points).
  virtual void promoteReference(std::span<const AlignPoint> points_ref) = 0;

  /// Whether promoteReference was called since creation.
  virtual bool hasReference() const = 0;

  /// Aligns the frame loaded last to the reference, starting at `T_cam_ref_guess`.
  virtual AlignResult align(const SE3d& T_cam_ref_guess) = 0;

  virtual AlignTimes times() const = 0;
  virtual StageTimer timer() const = 0;
};

}  // namespace glide
