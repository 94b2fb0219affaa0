#include "gpu/align_plan.h"

#include "gpu/fused_plan.h"
#include "gpu/paper_plan.h"

namespace glide {

Result<std::unique_ptr<AlignPlan>> createAlignPlan(const GpuAlignSpec& spec) {
  if (spec.tuning.plan == GpuPlan::paper) return PaperPlan::create(spec);
  return FusedPlan::create(spec);
}

}  // namespace glide
