#pragma once

#include "gpu/align_layout.h"
#include "gpu/gpu_commands.h"
#include "photometric/align_types.h"

#include <optional>

namespace glide {

/// The state of one alignment on the GPU, from the guess to the result. Lives on the GL thread.
class AlignStateBuffer {
 public:
  static AlignStateBuffer allocate();

  /// Sends the guess; the weights start at one.
  void start(const SE3d& T_cam_ref_guess) const;
  /// Waits for the GPU and reads the state: the one wait and the one readback of a frame. Nothing
  /// when the GPU does not answer in time.
  std::optional<GpuAlignState> finish(GpuCommands& commands) const;

  const GlBuffer& buffer() const { return buffer_; }
  bool isComplete() const { return buffer_.isComplete(); }
  void abandon() { buffer_.abandon(); }

 private:
  explicit AlignStateBuffer(GlBuffer buffer) : buffer_(std::move(buffer)) {}

  GlBuffer buffer_;
};

/// The state that start() sends.
GpuAlignState initialState(const SE3d& T_cam_ref_guess);

/// What a finished state says, in double.
AlignResult toResult(const GpuAlignState& state);

}  // namespace glide
