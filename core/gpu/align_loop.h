#pragma once

#include "gpu/align_layout.h"
#include "gpu/align_state.h"
#include "gpu/compute_program.h"
#include "gpu/gpu_pyramid.h"
#include "gpu/gpu_reference.h"

namespace glide {

/// What a frame brings to the iterations.
struct TrackInput {
  const GpuPyramid& frame;
  const AlignStateBuffer& state;
};

/// The iterations of one alignment, issued without waiting; pose, weights and the decision to stop
/// stay on the GPU (shaders/align_residual.comp and align_solve.comp). The caller has bound the
/// constants to uniform binding 0.
class AlignLoop {
 public:
  static Result<AlignLoop> create(const GpuAlignSpec& spec);

  /// Issues every iteration of every level, coarse to fine.
  void run(const TrackInput& input, const GpuReference& reference, GpuCommands& commands) const;

  /// The two halves of an iteration, for tests of each kernel. Barriered for shader storage reads.
  void residual(const TrackInput& input,
                const GpuReference& reference,
                int level,
                GpuCommands& commands) const;
  void solve(const TrackInput& input,
             const GpuReference& reference,
             int level,
             GpuCommands& commands) const;
  const GlBuffer& sums() const { return sums_; }
  const GlBuffer& weights() const { return weights_; }
  bool isComplete() const { return allComplete(sums_, weights_); }
  void abandon() { abandonAll(residual_, solve_, sums_, weights_); }

 private:
  AlignLoop(ComputeProgram residual, ComputeProgram solve, const GpuAlignSpec& spec);

  ComputeProgram residual_, solve_;
  int group_size_, max_iterations_;
  GlBuffer sums_, weights_;
};

}  // namespace glide
