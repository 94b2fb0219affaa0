#pragma once

namespace glide {

/// How an alignment is cut into commands.
enum class GpuPlan {
  fused,  ///< Coarse levels iterate inside one workgroup; a fine level's iteration is one or two
          ///< dispatches; what is issued after convergence does nothing.
  paper,  ///< The paper's section III: residual, reduction and solve are three dispatches per
          ///< iteration, all iterations are done.
};

/// How the next pyramid level is made.
enum class PyramidKernel {
  strip,     ///< One dispatch a level; each invocation slides down a strip of rows.
  tile,      ///< One dispatch a level; a workgroup shares its tile.
  two_pass,  ///< The paper's: horizontal, then vertical blur through a temporary texture.
};

/// What a device may be tuned by; the autotuner chooses it, the program cache keeps it.
struct GpuTuning {
  int group_size = 64;  ///< invocations per workgroup: 32, 64 or 128
  GpuPlan plan = GpuPlan::fused;
  PyramidKernel pyramid = PyramidKernel::strip;
  /// Levels with at most so many pixels iterate inside one workgroup (GpuPlan::fused).
  int single_group_pixels = 24'000;
};

}  // namespace glide
