#include "replay/app/job.h"
#include "replay/app/replay_loop.h"
#include "replay/common/text.h"
#include "replay/evaluation/evaluate.h"
#include "replay/outputs/frames_csv.h"
#include "replay/outputs/map_ply.h"
#include "replay/outputs/statistics.h"
#include "replay/outputs/stats_json.h"
#include "replay/outputs/summary.h"

#include <fmt/format.h>

#include <iostream>
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

std::optional<Failure> writeAll(const std::filesystem::path& folder,
                                const std::vector<std::pair<std::string, std::string>>& files) {
  for (const auto& [name, text] : files) {
    const Status status = writeFile(folder / name, text);
    if (!status) return Failure{kUnreadableInput, status.error().message};
  }
  return std::nullopt;
}

std::optional<Failure> endWatchers(const Job& job, const FrameCounts& counts) {
  std::optional<Trajectory> truth;
  if (job.truth) truth = truthInFrame(*job.truth, RigFrame::camera, job.calibration.T_body_cam);
  for (const auto& watcher : job.watchers) {
    const Status status =
        watcher->onEnd({job.run, job.trajectories, counts, job.accuracy, truth, job.output});
    if (!status) return Failure{kUnreadableInput, status.error().message};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Failure> runFrames(Job& job) {
  RunRecord& run = job.run;
  run.source = job.source.frames->info();
  run.config = job.config;
  run.pace = job.options.pace;
  ProgressDisplay progress(job.options.progress, run.source.frames);
  const LoopObservers observers{job.log, progress, job.watchers};
  AppInput input(job.options.input);
  const Player player{*job.session, input};
  const Status status = replayFrames(*job.source.frames, player, observers, run);
  if (!status && status.error().code == ErrorCode::unsupported)
    return Failure{kNoGl, status.error().message};
  if (!status)
    return Failure{kUnreadableInput, "the session refused a frame: " + status.error().message};
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
  const std::string summary = summaryText({job.run, counts, job.accuracy, job.output});
  job.log.note(summary);
  (job.options.json ? std::cerr : std::cout) << summary << std::flush;
  if (job.options.json) std::cout << stats << std::flush;
  if (auto failure = writeAll(job.output,
                              {{"trajectory.tum", tumText(job.written.recomposed)},
                               {"trajectory_live.tum", tumText(job.written.live)},
                               {"keyframes.tum", tumText(job.written.keyframes)},
                               {"frames.csv", framesCsv(job.run)},
                               {"map.ply", mapPly(*job.run.map)},
                               {"stats.json", stats}})) {
    return failure;
  }
  return endWatchers(job, counts);
}

std::optional<Failure> judgeRun(const Job& job) {
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
