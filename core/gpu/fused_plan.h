#pragma once

#include "gpu/align_loop.h"
#include "gpu/align_plan.h"
#include "gpu/gpu_reference.h"

namespace glide {

/// GpuPlan::fused: the factored cache and the kernels of shaders/align_*.comp.
class FusedPlan final : public AlignPlan {
 public:
  static Result<std::unique_ptr<AlignPlan>> create(const GpuAlignSpec& spec);

  void precompute(const GpuPyramid& pyramid,
                  std::span<const AlignPoint> points_ref,
                  GpuCommands& commands) override;
  void track(const GpuPyramid& frame,
             const AlignStateBuffer& state,
             GpuCommands& commands) const override;
  bool isComplete() const override { return allComplete(reference_, loop_); }
  void abandon() override { abandonAll(reference_, loop_); }

 private:
  FusedPlan(GpuReference reference, AlignLoop loop)
      : reference_(std::move(reference)), loop_(std::move(loop)) {}

  GpuReference reference_;
  AlignLoop loop_;
};

}  // namespace glide
