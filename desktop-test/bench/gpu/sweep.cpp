#include "bench/gpu/sweep.h"

#include "bench/gpu/report.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Those of Sweep::points, then those of Sweep::patches.
std::vector<Workload> workloadsOf(const Workload& common) {
  std::vector<Workload> workloads;
  for (const int points : kPoints) {
    workloads.push_back(common);
    workloads.back().points = points;
  }
  for (const int patch : kPatches) {
    workloads.push_back(common);
    workloads.back().patch = patch;
  }
  return workloads;
}

/// The fastest of each view's frames, mean over the views: other work on the machine only slows,
/// and long frames more than short ones.
double undisturbedMs(const PlanRun& run, std::size_t views) {
  const std::vector<double>& times = run.frameTimes();
  views = std::min(views, times.size());
  double sum = 0.0;
  for (std::size_t view = 0; view < views; ++view) {
    double fastest = times[view];
    for (std::size_t i = view; i < times.size(); i += views) fastest = std::min(fastest, times[i]);
    sum += fastest;
  }
  return sum / static_cast<double>(views);
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
  const std::vector<Workload> workloads = workloadsOf(options.workload);
  std::vector<BenchScene> scenes;
  for (const Workload& workload : workloads) scenes.push_back(makeBenchScene(workload));
  std::vector<PlanRun> runs;
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    for (const PlanRun::Spec& spec : specsOf(options, Maths::own, GpuTiming::stages)) {
      auto run = PlanRun::create(caps, workloads[i], scenes[i], spec);
      if (!run) return run.error();
      runs.push_back(std::move(*run));
    }
  }
  const Status played = playInterleaved(options.workload.frames, &runs);
  if (!played) return played.error();

  Sweep sweep{gpuJson(caps, runs.front()), options.workload, options.plans, {}, {}};
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    SweepPoint point{workloads[i].points, workloads[i].patch, {}};
    for (std::size_t plan = 0; plan < options.plans.size(); ++plan) {
      const PlanRun& run = runs[i * options.plans.size() + plan];
      point.frame_ms.push_back(undisturbedMs(run, scenes[i].frames.size()));
    }
    (i < std::size(kPoints) ? sweep.points : sweep.patches).push_back(std::move(point));
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
      "# Frame cost, {}\n\n{}x{}, {} levels; upload, pyramid, track and readback, the fastest "
      "frame "
      "of each view in {} frames, mean over the views; timer: {}\n\n{}\n{}\nGrowth is {} than that "
      "of the patch pixels.\n",
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
