#pragma once

#include "gpu/align_layout.h"
#include "gpu/compute_program.h"
#include "gpu/gpu_pyramid.h"
#include "gpu/gpu_reference.h"
#include "photometric/align_types.h"

#include <optional>

namespace glide {

/// The iterations of one alignment, issued without waiting; pose, weights and the decision to stop
/// stay on the GPU (shaders/align_residual.comp and align_solve.comp). The caller has bound the
/// constants to uniform binding 0.
class AlignLoop {
 public:
  static Result<AlignLoop> create(const GpuAlignSpec& spec);

  /// Sends the guess; the weights start at one.
  void start(const SE3d& T_cam_ref_guess) const;
  /// Issues every iteration of every level, coarse to fine.
  void run(const GpuPyramid& frame, const GpuReference& reference, GpuCommands& commands) const;
  /// Waits for the GPU and reads the state: the one wait and the one readback of a frame. Nothing
  /// when the GPU does not answer in time.
  std::optional<GpuAlignState> finish(GpuCommands& commands) const;

  /// The two halves of an iteration, for tests of each kernel. Barriered for shader storage reads.
  void residual(const GpuPyramid& frame,
                const GpuReference& reference,
                int level,
                GpuCommands& commands) const;
  void solve(const GpuReference& reference, int level, GpuCommands& commands) const;
  const GlBuffer& state() const { return state_; }
  const GlBuffer& sums() const { return sums_; }
  const GlBuffer& weights() const { return weights_; }

 private:
  AlignLoop(ComputeProgram residual, ComputeProgram solve, const GpuAlignSpec& spec);

  ComputeProgram residual_, solve_;
  int group_size_, max_iterations_;
  GlBuffer sums_, weights_, state_;
};

/// The state that start() sends.
GpuAlignState initialState(const SE3d& T_cam_ref_guess);

/// What a finished state says, in double.
AlignResult toResult(const GpuAlignState& state);

}  // namespace glide
