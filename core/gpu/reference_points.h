#pragma once

#include "gpu/gl_objects.h"
#include "photometric/align_types.h"

#include <span>
#include <vector>

namespace glide {

/// The points of a reference on the GPU: xyz in the reference camera and padding, as vec4. Lives on
/// the GL thread.
class ReferencePoints {
 public:
  static ReferencePoints allocate(int max_points);

  /// Sends the first max_points of `points_ref`.
  void set(std::span<const AlignPoint> points_ref);

  int count() const { return count_; }
  const GlBuffer& buffer() const { return buffer_; }
  bool isComplete() const { return buffer_.isComplete(); }
  void abandon() { buffer_.abandon(); }

 private:
  ReferencePoints() = default;

  GlBuffer buffer_;
  std::vector<float> staging_;  ///< as the kernels want them
  int count_ = 0;
};

}  // namespace glide
