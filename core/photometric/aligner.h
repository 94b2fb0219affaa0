#pragma once

#include "photometric/align_types.h"

#include "image/image.h"

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/result.h"

#include <span>
#include <variant>

namespace glide {

/// The image of a frame, borrowed: pixels on the CPU, or a texture of the current GL context.
using FrameImage = std::variant<ImageViewU8, Texture>;

/// The direct tracker's engine: holds the pyramid of the current frame and the cache of one
/// reference. Two implementations: CpuAligner and GpuAligner; the CPU one is the oracle of the GPU
/// one. One owner, one thread (the GL thread for the GPU).
class Aligner {
 public:
  virtual ~Aligner() = default;
  Aligner() = default;
  Aligner(const Aligner&) = delete;
  Aligner& operator=(const Aligner&) = delete;

  /// Takes a new frame: upload and pyramid. Pixels have the camera's size. An error when the image
  /// cannot be taken: a texture by the CPU, or one that the GPU cannot read (gpu/texture_pass.h).
  /// The frame before stays loaded then.
  virtual Status loadFrame(const FrameImage& image) = 0;

  /// Makes the frame loaded last the reference: its pyramid is promoted, not rebuilt, and the
  /// inverse-compositional cache is computed for `points_ref` (at most Config::Direct::max_points).
  virtual void promoteReference(std::span<const AlignPoint> points_ref) = 0;

  /// Whether promoteReference was called since creation.
  virtual bool hasReference() const = 0;

  /// Aligns the frame loaded last to the reference, starting at `T_cam_ref_guess`.
  virtual AlignResult align(const SE3d& T_cam_ref_guess) = 0;

  /// Whether it can go on in the GL context that is current: not without one, not in one that does
  /// not share objects with that of creation, and not after a loss. The CPU always can.
  virtual bool isUsable() const = 0;

  /// Forgets what it has on the device without a GL call: that context is gone. Only destruction
  /// may follow.
  virtual void abandon() = 0;

  virtual AlignTimes times() const = 0;
  virtual StageTimer timer() const = 0;
};

}  // namespace glide
