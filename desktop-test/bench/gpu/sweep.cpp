#include "bench/gpu/sweep.h"

#include "bench/gpu/report.h"

#include <fmt/format.h>

namespace glide::gpubench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPoints[] = {250, 500, 1000, 2000, 4000};
constexpr int kPatches[] = {5, 7, 9, 11, 13};
/// Medians of a shared machine repeat within so much.
constexpr double kNoise = 1.15;

bool growsLinearly(const std::vector<SweepPoint>& series, std::size_t plan) {
  const auto holds = [plan](const SweepPoint& less, const SweepPoint& more) {
    return more.frame_ms[plan] / less.frame_ms[plan] <= kNoise * more.pixels() / less.pixels();
  };
  for (std::size_t i = 1; i < series.size(); ++i) {
    if (!holds(series[i - 1], series[i])) return false;
  }
  return holds(series.front(), series.back());
}

/// Measures one workload, and takes the GPU's name from it.
Result<SweepPoint> measurePoint(const GlCaps& caps, const Workload& workload, Sweep* sweep) {
  const BenchScene scene = makeBenchScene(workload);
  std::vector<PlanRun::Spec> specs;
  for (const GpuPlan plan : sweep->plans) specs.push_back({plan, Maths::own, GpuTiming::stages});
  const auto runs = measurePlans(caps, workload, scene, specs);
  if (!runs) return runs.error();
  SweepPoint point{workload.points, workload.patch, {}};
  for (const PlanRun& run : *runs) point.frame_ms.push_back(spreadOf(run.frameTimes()).median);
  sweep->gpu = gpuJson(caps, runs->front());
  return point;
}

Json seriesJson(const Sweep& sweep, const std::vector<SweepPoint>& series) {
  Json rows = Json::array();
  for (const SweepPoint& point : series) {
    Json row{{"points", point.points}, {"patch", point.patch}};
    for (std::size_t i = 0; i < sweep.plans.size(); ++i) {
      row[planName(sweep.plans[i]) + "_ms"] = point.frame_ms[i];
    }
    rows.push_back(row);
  }
  return rows;
}

std::string seriesMarkdown(const Sweep& sweep, const std::vector<SweepPoint>& series) {
  std::string head = "| points | patch | patch pixels, relative |", rule = "|---:|---:|---:|";
  for (const GpuPlan plan : sweep.plans) {
    head += fmt::format(" {} ms | relative |", planName(plan));
    rule += "---:|---:|";
  }
  std::string table = head + "\n" + rule + "\n";
  for (const SweepPoint& point : series) {
    table += fmt::format("| {} | {} | {:.2f} |",
                         point.points,
                         point.patch,
                         point.pixels() / series.front().pixels());
    for (std::size_t i = 0; i < point.frame_ms.size(); ++i) {
      table += fmt::format(
          " {:.2f} | {:.2f} |", point.frame_ms[i], point.frame_ms[i] / series.front().frame_ms[i]);
    }
    table += "\n";
  }
  return table;
}

}  // namespace

bool Sweep::isLinear() const {
  for (std::size_t plan = 0; plan < plans.size(); ++plan) {
    if (!growsLinearly(points, plan) || !growsLinearly(patches, plan)) return false;
  }
  return true;
}

Result<Sweep> measureSweep(const GlCaps& caps, const Options& options) {
  Sweep sweep;
  sweep.workload = options.workload;
  sweep.plans = options.plans;
  for (const int points : kPoints) {
    Workload workload = options.workload;
    workload.points = points;
    auto point = measurePoint(caps, workload, &sweep);
    if (!point) return point.error();
    sweep.points.push_back(std::move(*point));
  }
  for (const int patch : kPatches) {
    Workload workload = options.workload;
    workload.patch = patch;
    auto point = measurePoint(caps, workload, &sweep);
    if (!point) return point.error();
    sweep.patches.push_back(std::move(*point));
  }
  return sweep;
}

Json toJson(const Sweep& sweep) {
  return {{"gpu", sweep.gpu},
          {"points", seriesJson(sweep, sweep.points)},
          {"patch", seriesJson(sweep, sweep.patches)},
          {"linear", sweep.isLinear()}};
}

std::string toMarkdown(const Sweep& sweep) {
  const Workload& workload = sweep.workload;
  return fmt::format(
      "# Frame cost, {}\n\n{}x{}, {} levels; median of {} frames (upload, pyramid, track, "
      "readback), timer: {}\n\n{}\n{}\nGrowth is {} than that of the patch pixels.\n",
      sweep.gpu["renderer"].get<std::string>(),
      workload.width,
      workload.height,
      workload.levels,
      workload.frames,
      sweep.gpu["timer"].get<std::string>(),
      seriesMarkdown(sweep, sweep.points),
      seriesMarkdown(sweep, sweep.patches),
      sweep.isLinear() ? "nowhere faster" : "FASTER");
}

}  // namespace glide::gpubench
