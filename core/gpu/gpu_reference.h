#pragma once

#include "gpu/align_layout.h"
#include "gpu/compute_program.h"
#include "gpu/gpu_commands.h"
#include "gpu/gpu_pyramid.h"
#include "gpu/point_order.h"
#include "gpu/reference_points.h"
#include "photometric/align_types.h"

#include <span>

namespace glide {

/// The inverse-compositional cache of one reference, on the GPU (shaders/align_precompute.comp).
class GpuReference {
 public:
  static Result<GpuReference> create(const GpuAlignSpec& spec);

  /// Describes the first max_points of `points_ref` in the reference's pyramid, at all levels where
  /// they may be valid. The caller has bound the constants to uniform binding 0. Barriered for
  /// shader storage reads.
  void precompute(const GpuPyramid& pyramid,
                  std::span<const AlignPoint> points_ref,
                  GpuCommands& commands);

  /// In the order in which the kernels have them.
  const PointOrder& order() const { return order_; }
  /// GpuPointRecord [level][max_points]; of a level those of its first order().count() points.
  const GlBuffer& records() const { return records_; }
  /// Floats [level][row][pair of pixels][e gx gy][max_points][2]; the last pair of a row has one.
  const GlBuffer& pixels() const { return pixels_; }
  bool isComplete() const { return allComplete(points_, records_, pixels_); }
  void abandon() { abandonAll(kernel_, points_, records_, pixels_); }

 private:
  GpuReference(ComputeProgram kernel, const GpuAlignSpec& spec);

  ComputeProgram kernel_;
  int group_size_;
  PointOrder order_;
  ReferencePoints points_;
  GlBuffer records_, pixels_;
};

}  // namespace glide
