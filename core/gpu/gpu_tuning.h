#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

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

/// What a device may be tuned by; the autotuner chooses it, the device cache keeps it.
struct GpuTuning {
  int group_size = 64;  ///< invocations per workgroup: 32, 64 or 128
  GpuPlan plan = GpuPlan::fused;
  PyramidKernel pyramid = PyramidKernel::strip;
  /// Levels with at most so many pixels iterate inside one workgroup (GpuPlan::fused).
  int single_group_pixels = 24'000;

  bool operator==(const GpuTuning&) const = default;
};

/// The bytes that the device cache keeps.
std::vector<std::byte> encodeTuning(const GpuTuning& tuning);
/// Nothing when the bytes are not those of a tuning that this version of the library can run.
std::optional<GpuTuning> decodeTuning(std::span<const std::byte> bytes);

}  // namespace glide
