#include "replay/app/job.h"
#include "replay/app/replay_loop.h"
#include "replay/common/terminal.h"
#include "replay/common/text.h"
#include "replay/evaluation/evaluate.h"
#include "replay/outputs/frames_csv.h"
#include "replay/outputs/map_glb.h"
#include "replay/outputs/map_ply.h"
#include "replay/outputs/statistics.h"
#include "replay/outputs/stats_json.h"
#include "replay/outputs/summary.h"

#include <fmt/format.h>

#include <iostream>
#include <unistd.h>
#include <utility>

namespace glide::replay {
namespace {

constexpr int kJsonIndent = 2;

std::string jsonText(const nlohmann::ordered_json& json) {
  // File names need not be UTF-8; a dump that throws at the end of a run would be a pity.
  return json.dump(kJsonIndent, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Without a scale the lever arm has no length: the camera's trajectory is written instead.
std::optional<double> metersPerUnit(const Job& job) {
  const Trajectory truth = truthInFrame(*job.truth, RigFrame::camera, job.calibration.T_body_cam);
  const auto error = absoluteError(truth, job.trajectories.camera.recomposed);
  return error ? std::optional(error->scale) : std::nullopt;
}

/// One file that cannot be written keeps none of the others from it. The first failure.
std::optional<Failure> writeAll(const std::filesystem::path& folder,
                                const std::vector<std::pair<std::string, std::string>>& files) {
  std::optional<Failure> first;
  for (const auto& [name, text] : files) {
    const Status status = writeFile(folder / name, text);
    if (!status && !first) first = Failure{kUnreadableInput, status.error().message};
  }
  return first;
}

/// The first failure, those while the replay ran included.
std::optional<Failure> endWatchers(const Job& job, const FrameCounts& counts) {
  std::optional<Error> fault = job.watcher_fault;
  std::optional<Trajectory> truth;
  if (job.truth) truth = truthInFrame(*job.truth, RigFrame::camera, job.calibration.T_body_cam);
  for (const auto& watcher : job.watchers) {
    const Status status = watcher->onEnd(
        {job.run, job.trajectories, counts, job.accuracy, truth, job.output, job.colors});
    if (!status && !fault) fault = status.error();
  }
  return fault ? std::optional(Failure{kUnreadableInput, fault->message}) : std::nullopt;
}

/// When it returns, the progress bar has ended, and signals end the program again.
Status playFrames(Job& job) {
  ProgressDisplay progress(job.options.progress, job.run.source.frames);
  const LoopObservers observers{job.log, progress, job.watchers, job.watcher_fault};
  AppInput input(job.options.input);
  const Player player{*job.session, input};
  const Interrupt interrupt;
  FrameFeed feed(*job.source.frames, job.run.pace, interrupt);
  return replayFrames(feed, player, observers, job.run);
}

/// "120 of 320 frames", or "120 frames" of a source that does not know its end.
std::string framesDone(const RunRecord& run) {
  const int total = run.source.frames;
  return fmt::format(
      "{}{} frames", run.frames.size(), total > 0 ? fmt::format(" of {}", total) : "");
}

}  // namespace

std::optional<Failure> runFrames(Job& job) {
  RunRecord& run = job.run;
  run.source = job.source.frames->info();
  run.config = job.config;
  run.pace = job.options.pace;
  const Status status = playFrames(job);
  if (!status && status.error().code == ErrorCode::unsupported)
    return Failure{kNoGl, status.error().message};
  if (!status) return Failure{kUnreadableInput, status.error().message};
  if (run.interrupted) {
    job.log.say(fmt::format(
        "interrupted after {}: writing what was tracked so far (Ctrl-C again ends at once)",
        framesDone(run)));
  }
  run.skips = job.source.frames->skips().skips();
  for (const Skip& skip : run.skips) job.log.note(describe(skip, run.source.listed));
  return std::nullopt;
}

std::optional<Failure> evaluateRun(Job& job) {
  job.trajectories = buildTrajectories(job.run);
  job.written = job.trajectories.camera;
  if (job.trajectories.of_older_maps > 0) {
    job.log.say(fmt::format("{} frames of maps that were given up are left out",
                            job.trajectories.of_older_maps));
  }
  if (!job.truth) return std::nullopt;
  RigFrame frame = RigFrame::camera;
  if (job.options.trajectory_frame == TrajectoryFrame::body) {
    const std::optional<double> scale = metersPerUnit(job);
    if (scale) {
      frame = RigFrame::body;
      job.written = toBody(job.written, *job.calibration.T_body_cam, *scale);
    } else {
      job.log.say("no scale could be found: the trajectories stay those of the camera");
    }
  }
  const Trajectory truth = truthInFrame(*job.truth, frame, job.calibration.T_body_cam);
  job.accuracy = evaluate(truth, job.written);
  job.accuracy->truth_file = job.truth_file->string();
  return writeAll(job.output, {{"groundtruth.tum", tumText(truth)}});
}

std::optional<Failure> writeOutputs(Job& job) {
  const FrameCounts counts = countFrames(job.run, job.trajectories);
  const std::string stats = jsonText(statsJson(job.run, counts, job.accuracy));
  const bool has_color = terminalOf(job.options.json ? STDERR_FILENO : STDOUT_FILENO).has_color;
  job.log.note(summaryText({job.run, counts, job.accuracy, job.output, false}));
  (job.options.json ? std::cerr : std::cout)
      << summaryText({job.run, counts, job.accuracy, job.output, has_color}) << std::flush;
  if (job.options.json) std::cout << stats << std::flush;
  const std::optional<Failure> failure =
      writeAll(job.output,
               {{"trajectory.tum", tumText(job.written.recomposed)},
                {"trajectory_live.tum", tumText(job.written.live)},
                {"keyframes.tum", tumText(job.written.keyframes)},
                {"frames.csv", framesCsv(job.run)},
                {"map.ply", mapPly(*job.run.map, job.colors)},
                {"map.glb", mapGlb(job.run, job.trajectories, job.colors)},
                {"stats.json", stats}});
  const std::optional<Failure> watchers_failure = endWatchers(job, counts);
  return failure ? failure : watchers_failure;
}

std::optional<Failure> judgeRun(const Job& job) {
  if (job.run.interrupted) {
    return Failure{
        kInterrupted,
        fmt::format("interrupted after {}; the files in {} hold what was tracked until then",
                    framesDone(job.run),
                    job.output.string())};
  }
  const FrameCounts counts = countFrames(job.run, job.trajectories);
  if (counts.in == 0) return Failure{kUnreadableInput, "no frame could be read"};
  if (!counts.first_pose_index) {
    return Failure{kNeverInitialised, "never initialised: " + initializationHint(job.run)};
  }
  const double required = job.options.require_tracked.value_or(0.0);
  if (counts.tracked_ratio < required) {
    return Failure{
        kTrackedTooLittle,
        fmt::format(
            "tracked ratio {:.4f} is below the required {:.4f}", counts.tracked_ratio, required)};
  }
  return std::nullopt;
}

}  // namespace glide::replay
