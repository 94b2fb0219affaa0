#pragma once

#include "gpu/compute_program.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_commands.h"

#include <vector>

namespace glide {

/// The levels of a frame on the GPU, r32f grey levels 0..255; sizes as image/pyramid.h.
struct GpuPyramid {
  std::vector<GlTexture> levels;

  static GpuPyramid allocate(int width, int height, int levels);
};

/// Fills levels 1.. of a pyramid from level 0 (shaders/pyramid_down.comp).
class PyramidPass {
 public:
  static Result<PyramidPass> create(int group_size);

  /// Level 0 is complete and barriered for texture fetches; on return so are all levels.
  void run(const GpuPyramid& pyramid, GpuCommands& commands) const;

 private:
  PyramidPass(ComputeProgram down, int group_size)
      : down_(std::move(down)), group_size_(group_size) {}

  ComputeProgram down_;
  int group_size_;
};

}  // namespace glide
