#pragma once

#include "gpu/compute_program.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_commands.h"
#include "gpu/gpu_tuning.h"
#include "gpu/program_cache.h"

#include <optional>
#include <vector>

namespace glide {

/// The levels of a frame on the GPU, r32f grey levels 0..255; sizes as image/pyramid.h.
struct GpuPyramid {
  std::vector<GlTexture> levels;

  static GpuPyramid allocate(int width, int height, int levels);
  bool isComplete() const;
  void abandon();
};

/// The kernel that a plan uses: the paper's plan has its own, else GpuTuning::pyramid.
PyramidKernel pyramidKernel(const GpuTuning& tuning);

/// Fills levels 1.. of a pyramid from level 0, by one of the kernels shaders/pyramid_*. All kernels
/// make the same levels up to rounding.
class PyramidPass {
 public:
  /// For pyramids of the size of `pyramid`.
  static Result<PyramidPass> create(const GpuTuning& tuning,
                                    const GpuPyramid& pyramid,
                                    const ProgramCache& programs);

  /// Level 0 is complete and barriered for texture fetches; on return so are all levels.
  void run(const GpuPyramid& pyramid, GpuCommands& commands) const;
  bool isComplete() const { return !second_ || second_->blurred_rows.isComplete(); }
  void abandon();

 private:
  /// What the paper's kernel needs more than the others.
  struct SecondPass {
    ComputeProgram blur_columns;
    GlTexture blurred_rows;
  };
  PyramidPass(PyramidKernel kernel, int group_rows, ComputeProgram program)
      : kernel_(kernel), group_rows_(group_rows), program_(std::move(program)) {}

  void runFused(const GlTexture& finer, const GlTexture& coarser, GpuCommands& commands) const;
  void runTwoPass(const GlTexture& finer, const GlTexture& coarser, GpuCommands& commands) const;

  PyramidKernel kernel_;
  int group_rows_;  ///< of 32 invocations
  ComputeProgram program_;
  std::optional<SecondPass> second_;
};

}  // namespace glide
