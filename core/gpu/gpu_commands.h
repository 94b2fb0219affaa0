#pragma once

#include "gpu/gl.h"

#include <array>
#include <cstddef>

namespace glide {

/// The steps of a direct frame, in the order in which a GPU does them.
enum class GpuStage { upload, pyramid, precompute, track, readback };
inline constexpr std::size_t kGpuStages = 5;

/// Commands of one stage.
struct GpuCommandCount {
  int dispatches = 0;
  int barriers = 0;
};

class GpuTimer;

/// Issues dispatches and barriers, counts them by stage (what docs/benchmarks.md calls the command
/// count) and lets a timer time the stages. All compute work of core/gpu goes through it.
class GpuCommands {
 public:
  /// Counts without a timer.
  GpuCommands() = default;
  /// `timer` outlives this.
  explicit GpuCommands(GpuTimer* timer) : timer_(timer) {}

  /// Later commands count for `stage`; its count starts at zero.
  void beginStage(GpuStage stage);
  /// What the stage has issued so far is its work.
  void endStage();
  /// Later work of the track stage is that of `level`, or of it and those below when one command
  /// does several: for benchmarks that look at levels (GpuTiming::levels).
  void beginLevel(int level);
  void dispatch(GLuint groups_x, GLuint groups_y);
  /// glMemoryBarrier.
  void barrier(GLbitfield bits);
  const GpuCommandCount& count(GpuStage stage) const {
    return counts_[static_cast<std::size_t>(stage)];
  }

 private:
  GpuCommandCount& current() { return counts_[static_cast<std::size_t>(stage_)]; }

  std::array<GpuCommandCount, kGpuStages> counts_{};
  GpuStage stage_ = GpuStage::upload;
  GpuTimer* timer_ = nullptr;
};

}  // namespace glide
