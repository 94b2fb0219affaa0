#pragma once

#include "bench/gpu/plan_run.h"

#include <optional>
#include <vector>

namespace glide::gpubench {

/// Median and 95th percentile of a series.
struct Spread {
  double median = 0.0, p95 = 0.0;
};
Spread spreadOf(std::vector<double> values);

/// What was measured of the plans on one workload.
struct Measurement {
  GlCaps caps;
  Workload workload;
  GpuTuning fused;  ///< of GpuPlan::fused
  double bandwidth_gb_s = 0.0;
  std::vector<PlanRun> runs;    ///< one a plan, timed by stage
  std::vector<PlanRun> levels;  ///< the same plans once more, timed by level
  /// Largest difference between the plans' poses, norm of the twist, without robust weights;
  /// nothing when only one plan was run.
  std::optional<double> pose_difference;
};

/// One for each plan of the options.
std::vector<PlanRun::Spec> specsOf(const Options& options, Maths maths, GpuTiming timing);

/// So many frames of each after a warm-up, in turn: what disturbs the machine disturbs all. Errors
/// as PlanRun::check.
Status playInterleaved(int frames, std::vector<PlanRun>* runs);

/// Runs all plans of `specs` on the same frames, interleaved.
Result<std::vector<PlanRun>> measurePlans(const GlCaps& caps,
                                          const Workload& workload,
                                          const BenchScene& scene,
                                          const std::vector<PlanRun::Spec>& specs);

/// Stages, levels, agreement and bandwidth. `scene` outlives the result.
Result<Measurement> measure(const GlCaps& caps, const Options& options, const BenchScene& scene);

}  // namespace glide::gpubench
