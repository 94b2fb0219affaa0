#include "bench/gpu/measure.h"

#include "bench/gpu/bandwidth.h"

#include <algorithm>

namespace glide::gpubench {
namespace {

/// Drivers build programs and grow buffers at first use.
constexpr int kWarmUpFrames = 2;

/// Over the scene's frames.
Result<double> poseDifference(const GlCaps& caps, const Options& options, const BenchScene& scene) {
  std::vector<PlanRun> runs;
  for (const auto& spec : specsOf(options, Maths::unweighted, GpuTiming::passive)) {
    auto run = PlanRun::create(caps, options.workload, scene, spec);
    if (!run) return run.error();
    runs.push_back(std::move(*run));
  }
  double worst = 0.0;
  for (int i = 0; i < static_cast<int>(scene.frames.size()); ++i) {
    for (PlanRun& run : runs) run.frame(i);
    for (const PlanRun& run : runs) {
      if (Status found = run.check(); !found) return found.error();
    }
    const SE3d difference =
        runs.front().result().T_cam_ref.inverse() * runs.back().result().T_cam_ref;
    worst = std::max(worst, difference.log().norm());
  }
  return worst;
}

}  // namespace

std::vector<PlanRun::Spec> specsOf(const Options& options, Maths maths, GpuTiming timing) {
  std::vector<PlanRun::Spec> specs;
  for (const GpuPlan plan : options.plans) {
    GpuTuning tuning = options.fused;
    tuning.plan = plan;
    specs.push_back({tuning, maths, timing});
  }
  return specs;
}

Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(rank);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (rank - static_cast<double>(low)) * (values[high] - values[low]);
  };
  return {at(0.5), at(0.95)};
}

Status playInterleaved(int frames, std::vector<PlanRun>* runs) {
  for (int i = -kWarmUpFrames; i < frames; ++i) {
    for (PlanRun& run : *runs) {
      if (i == 0) run.restart();
      run.frame(std::max(i, 0));
      if (Status found = run.check(); !found) return found;
    }
  }
  return Unit{};
}

Result<std::vector<PlanRun>> measurePlans(const GlCaps& caps,
                                          const Workload& workload,
                                          const BenchScene& scene,
                                          const std::vector<PlanRun::Spec>& specs) {
  std::vector<PlanRun> runs;
  for (const PlanRun::Spec& spec : specs) {
    auto run = PlanRun::create(caps, workload, scene, spec);
    if (!run) return run.error();
    runs.push_back(std::move(*run));
  }
  if (Status played = playInterleaved(workload.frames, &runs); !played) return played.error();
  return runs;
}

Result<Measurement> measure(const GlCaps& caps, const Options& options, const BenchScene& scene) {
  Measurement measurement;
  measurement.caps = caps;
  measurement.workload = options.workload;
  measurement.fused = options.fused;
  const Result<double> bandwidth = measureBandwidth();
  if (!bandwidth) return bandwidth.error();
  measurement.bandwidth_gb_s = *bandwidth;
  for (const GpuTiming timing : {GpuTiming::stages, GpuTiming::levels}) {
    auto runs = measurePlans(caps, options.workload, scene, specsOf(options, Maths::own, timing));
    if (!runs) return runs.error();
    (timing == GpuTiming::stages ? measurement.runs : measurement.levels) = std::move(*runs);
  }
  if (options.plans.size() < 2) return measurement;
  const Result<double> difference = poseDifference(caps, options, scene);
  if (!difference) return difference.error();
  measurement.pose_difference = *difference;
  return measurement;
}

}  // namespace glide::gpubench
