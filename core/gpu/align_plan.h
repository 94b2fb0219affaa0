#pragma once

#include "gpu/align_layout.h"
#include "gpu/align_state.h"
#include "gpu/gpu_commands.h"
#include "gpu/gpu_pyramid.h"
#include "photometric/align_types.h"

#include <memory>
#include <span>

namespace glide {

/// How the cache of a reference and the iterations over it are cut into GPU commands
/// (docs/algorithms/photometric-alignment.md, "Plans on the GPU"). Two implementations: FusedPlan
/// and PaperPlan. Owns the cache; makes no GL object after creation. Lives on the GL thread. The
/// caller of precompute and track has bound the constants to uniform binding 0.
class AlignPlan {
 public:
  virtual ~AlignPlan() = default;
  AlignPlan() = default;
  AlignPlan(const AlignPlan&) = delete;
  AlignPlan& operator=(const AlignPlan&) = delete;

  /// Caches the first max_points of `points_ref` in the reference's pyramid, all levels. Barriered
  /// for track().
  virtual void precompute(const GpuPyramid& pyramid,
                          std::span<const AlignPoint> points_ref,
                          GpuCommands& commands) = 0;

  /// Issues every iteration of every level, coarse to fine, on a state that has started. Waits for
  /// nothing; barriered for shader storage reads.
  virtual void track(const GpuPyramid& frame,
                     const AlignStateBuffer& state,
                     GpuCommands& commands) const = 0;

  /// Whether there was memory for the cache and the sums.
  virtual bool isComplete() const = 0;
  /// Forgets all names without a GL call: the context is gone.
  virtual void abandon() = 0;
};

/// The plan that `spec.tuning` names.
Result<std::unique_ptr<AlignPlan>> createAlignPlan(const GpuAlignSpec& spec);

}  // namespace glide
