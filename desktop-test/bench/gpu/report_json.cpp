#include "bench/gpu/report.h"

#include <cmath>

namespace glide::gpubench {
namespace {

using Json = nlohmann::ordered_json;

Json spreadJson(const std::vector<double>& times_ms) {
  const Spread spread = spreadOf(times_ms);
  return {{"median", spread.median}, {"p95", spread.p95}};
}

/// Dispatches, barriers and bytes are those of a frame: without precompute, which is done once a
/// reference.
Json planJson(const PlanRun& run) {
  Json plan;
  plan["upload_ms"] = spreadJson(run.times(GpuStage::upload));
  plan["pyramid_ms"] = spreadJson(run.times(GpuStage::pyramid));
  plan["precompute_ms"] = spreadJson(run.times(GpuStage::precompute));
  plan["track_ms"] = spreadJson(run.times(GpuStage::track));
  plan["readback_ms"] = spreadJson(run.times(GpuStage::readback));
  const auto traffic = run.traffic();
  GpuCommandCount commands;
  double bytes = 0.0;
  for (const GpuStage stage :
       {GpuStage::upload, GpuStage::pyramid, GpuStage::track, GpuStage::readback}) {
    commands.dispatches += run.commands().count(stage).dispatches;
    commands.barriers += run.commands().count(stage).barriers;
    bytes += traffic[static_cast<std::size_t>(stage)].total();
  }
  plan["dispatches"] = commands.dispatches;
  plan["barriers"] = commands.barriers;
  plan["bytes"] = std::llround(bytes);
  return plan;
}

}  // namespace

std::string planName(GpuPlan plan) { return plan == GpuPlan::paper ? "paper" : "fused"; }

Json gpuJson(const GlCaps& caps, const PlanRun& run) {
  return {{"vendor", caps.vendor},
          {"renderer", caps.renderer},
          {"version", caps.version},
          {"timer", run.usesQueries() ? "query" : "sync"}};
}

Json toJson(const Measurement& measurement) {
  Json root;
  root["gpu"] = gpuJson(measurement.caps, measurement.runs.front());
  for (const PlanRun& run : measurement.runs) {
    root["plans"][planName(run.plan())] = planJson(run);
  }
  root["pose_difference"] =
      measurement.pose_difference ? Json(*measurement.pose_difference) : Json(nullptr);
  return root;
}

}  // namespace glide::gpubench
