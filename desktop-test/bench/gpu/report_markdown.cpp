#include "bench/gpu/report.h"
#include "bench/gpu/traffic.h"

#include "image/pyramid.h"

#include <fmt/format.h>

namespace glide::gpubench {
namespace {

struct Row {
  const char* name;
  GpuStage stage;
};
constexpr Row kRows[] = {{"upload", GpuStage::upload},
                         {"pyramid", GpuStage::pyramid},
                         {"track", GpuStage::track},
                         {"readback", GpuStage::readback}};
constexpr Row kPrecompute = {"precompute, a reference", GpuStage::precompute};

constexpr double kBytesPerMb = 1e6;

/// Milliseconds that moving so much takes at least.
double floorMs(const Traffic& traffic, double bandwidth_gb_s) {
  return traffic.total() / (bandwidth_gb_s * kBytesPerMb);
}

std::string stageCells(const Measurement& measurement, const PlanRun& run, GpuStage stage) {
  const Spread ms = spreadOf(run.times(stage));
  const GpuCommandCount commands = run.commands().count(stage);
  const Traffic traffic = run.traffic()[static_cast<std::size_t>(stage)];
  return fmt::format(" {:.3f} / {:.3f} | {} / {} | {:.2f} / {:.2f} | {:.3f} |",
                     ms.median,
                     ms.p95,
                     commands.dispatches,
                     commands.barriers,
                     traffic.read / kBytesPerMb,
                     traffic.written / kBytesPerMb,
                     floorMs(traffic, measurement.bandwidth_gb_s));
}

/// paper / fused where both were run.
std::string ratioCell(double first_ms, double last_ms, std::size_t plans) {
  return plans < 2 ? "" : fmt::format(" {:.2f} |", first_ms / last_ms);
}

std::string stageRow(const Measurement& measurement, const Row& row) {
  const std::vector<PlanRun>& runs = measurement.runs;
  std::string line = fmt::format("| {} |", row.name);
  for (const PlanRun& run : runs) line += stageCells(measurement, run, row.stage);
  return line +
         ratioCell(spreadOf(runs.front().times(row.stage)).median,
                   spreadOf(runs.back().times(row.stage)).median,
                   runs.size()) +
         "\n";
}

std::string frameRow(const Measurement& measurement) {
  std::string line = "| frame |";
  for (const PlanRun& run : measurement.runs) {
    const Spread ms = spreadOf(run.frameTimes());
    line += fmt::format(" {:.3f} / {:.3f} | | | |", ms.median, ms.p95);
  }
  return line +
         ratioCell(spreadOf(measurement.runs.front().frameTimes()).median,
                   spreadOf(measurement.runs.back().frameTimes()).median,
                   measurement.runs.size()) +
         "\n";
}

std::string stageTable(const Measurement& measurement) {
  std::string head = "| stage |", rule = "|---|";
  for (const PlanRun& run : measurement.runs) {
    head +=
        fmt::format(" {} ms, median / p95 | dispatches / barriers | MB read / written | floor ms |",
                    planName(run.plan()));
    rule += "---:|---:|---:|---:|";
  }
  const bool compares = measurement.runs.size() > 1;
  std::string table = head + (compares ? " paper / fused |\n" : "\n");
  table += rule + (compares ? "---:|\n" : "\n");
  for (const Row& row : kRows) table += stageRow(measurement, row);
  return table + frameRow(measurement) + stageRow(measurement, kPrecompute);
}

/// Levels of track, timed one by one: with more waits than the stages, so that they do not add up
/// to it. A level whose work is part of a coarser one's command has no time of its own.
std::string levelTable(const Measurement& measurement) {
  const Workload& workload = measurement.workload;
  std::string head = "| track, level |", rule = "|---|";
  for (const PlanRun& run : measurement.levels) {
    head += fmt::format(" {} ms | iterations |", planName(run.plan()));
    rule += "---:|---:|";
  }
  std::string table = head + "\n" + rule + "\n";
  const int levels = pyramidLevels(workload.width, workload.height, workload.levels);
  for (int level = levels - 1; level >= 0; --level) {
    const int width = levelSide(workload.width, level), height = levelSide(workload.height, level);
    table += fmt::format("| {} ({}x{}) |", level, width, height);
    for (const PlanRun& run : measurement.levels) {
      const double ms = spreadOf(run.levelTimes(level)).median;
      table += ms > 0.0 ? fmt::format(" {:.3f} |", ms) : " with the level above |";
      table += fmt::format(" {:.1f} |", run.iterations()[static_cast<std::size_t>(level)]);
    }
    table += "\n";
  }
  return table;
}

/// How the fused plan was tuned.
std::string tuningText(const GpuTuning& tuning) {
  return fmt::format("fused: workgroups of {}, pyramid by {}, levels up to {} px in one workgroup",
                     tuning.group_size,
                     tuning.pyramid == PyramidKernel::tile ? "tiles" : "strips",
                     tuning.single_group_pixels);
}

}  // namespace

std::string toMarkdown(const Measurement& measurement) {
  const Workload& workload = measurement.workload;
  std::string text = fmt::format(
      "# {}\n\n{}, {}. {}x{}, {} points, patch {}, {} levels; {} frames, timer: {}; {}. Floor: "
      "what "
      "the counted bytes take at {:.1f} GB/s, which glCopyBufferSubData of 64 MiB reaches here.\n",
      measurement.caps.renderer,
      measurement.caps.vendor,
      measurement.caps.version,
      workload.width,
      workload.height,
      workload.points,
      workload.patch,
      workload.levels,
      workload.frames,
      measurement.runs.front().usesQueries() ? "query" : "sync",
      tuningText(measurement.fused),
      measurement.bandwidth_gb_s);
  text += "\n" + stageTable(measurement) + "\n" + levelTable(measurement);
  if (measurement.pose_difference) {
    text += fmt::format("\nWithout robust weights the plans' poses differ by {:.1e} at most.\n",
                        *measurement.pose_difference);
  }
  return text;
}

}  // namespace glide::gpubench
