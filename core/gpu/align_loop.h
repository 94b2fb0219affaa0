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
/// stay on the GPU. A coarse level (GpuTuning::single_group_pixels) is one dispatch of one
/// workgroup (shaders/align_coarse.comp), an iteration of a fine level is two (align_residual.comp,
/// align_solve.comp). The caller has bound the constants to uniform binding 0.
class AlignLoop {
 public:
  static Result<AlignLoop> create(const GpuAlignSpec& spec);

  /// Issues every iteration of every level, coarse to fine.
  void run(const TrackInput& input, const GpuReference& reference, GpuCommands& commands) const;

  /// The kernels, for tests of each. Barriered for shader storage reads.
  void residual(const TrackInput& input,
                const GpuReference& reference,
                int level,
                GpuCommands& commands) const;
  void solve(const TrackInput& input,
             const GpuReference& reference,
             int level,
             GpuCommands& commands) const;
  const GlBuffer& sums() const { return sums_; }
  bool isComplete() const { return allComplete(sums_); }
  void abandon() { abandonAll(programs_.residual, programs_.solve, programs_.coarse, sums_); }

 private:
  struct Programs {
    ComputeProgram residual, solve, coarse;
  };
  AlignLoop(Programs programs, const GpuAlignSpec& spec);

  void bind(const TrackInput& input, const GpuReference& reference) const;
  void iterateCoarse(const GpuReference& reference, int level, GpuCommands& commands) const;
  void iterateFine(const GpuReference& reference, int level, GpuCommands& commands) const;
  void issueResidual(int point_count, GpuCommands& commands) const;
  void issueSolve(GpuCommands& commands) const;

  Programs programs_;
  int group_size_, max_iterations_, min_points_, single_group_pixels_;
  GlBuffer sums_;
};

}  // namespace glide
