#include "gpu/fused_plan.h"

namespace glide {

Result<std::unique_ptr<AlignPlan>> FusedPlan::create(const GpuAlignSpec& spec) {
  Result<GpuReference> reference = GpuReference::create(spec);
  if (!reference) return reference.error();
  Result<AlignLoop> loop = AlignLoop::create(spec);
  if (!loop) return loop.error();
  return std::unique_ptr<AlignPlan>(new FusedPlan(std::move(*reference), std::move(*loop)));
}

void FusedPlan::precompute(const GpuPyramid& pyramid,
                           std::span<const AlignPoint> points_ref,
                           GpuCommands& commands) {
  reference_.precompute(pyramid, points_ref, commands);
}

void FusedPlan::track(const GpuPyramid& frame,
                      const AlignStateBuffer& state,
                      GpuCommands& commands) const {
  loop_.run({frame, state}, reference_, commands);
}

}  // namespace glide
