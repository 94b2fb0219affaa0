#include "replay/app/config_io.h"
#include "replay/app/job.h"
#include "replay/calibration/field_of_view.h"
#include "replay/common/text.h"
#include "replay/outputs/render_path.h"

#include "base/stopwatch.h"

#include "glide/config_text.h"

#include <fmt/format.h>

#include <ctime>
#include <utility>

namespace glide::replay {
namespace {

Failure usage(const std::string& message) { return {kUsage, message}; }
Failure unreadable(const Error& error) { return {kUnreadableInput, error.message}; }

std::optional<Failure> openFrames(Job& job) {
  auto source = openSource(job.options.source, job.options.selection, job.options.fps);
  if (!source) return unreadable(source.error());
  job.source = std::move(source).value();
  const SourceInfo& info = job.source.frames->info();
  job.log.note(fmt::format("source: {} {} ({} frames of {}, {}x{})",
                           info.kind,
                           info.path.string(),
                           info.frames,
                           info.listed,
                           info.width,
                           info.height));
  if (!job.options.render) return std::nullopt;
  const std::optional<std::string> danger = dangerToSource(*job.options.render, info.path);
  return danger ? std::optional(usage("--render: " + *danger)) : std::nullopt;
}

/// The size of a calibration that does not tell one is the images'.
std::optional<Failure> fitSize(const SourceInfo& info, Calibration& calibration) {
  CameraIntrinsics& camera = calibration.camera;
  if (camera.width == 0) camera.width = info.width;
  if (camera.height == 0) camera.height = info.height;
  if (camera.width == info.width && camera.height == info.height) return std::nullopt;
  return Failure{kUnreadableInput,
                 fmt::format("{}: the calibration is for {}x{} images, but those of {} are {}x{}",
                             calibration.origin,
                             camera.width,
                             camera.height,
                             info.path.string(),
                             info.width,
                             info.height)};
}

std::optional<Failure> openCalibration(Job& job) {
  const std::string& asked = job.options.calibration;
  const std::string origin = asked.empty() ? job.source.calibration : asked;
  if (!origin.empty()) {
    const SourceInfo& info = job.source.frames->info();
    Result<Calibration> calibration = isFieldOfView(origin)
                                          ? calibrationOfField(origin, info.width, info.height)
                                          : loadCalibration(origin);
    if (!calibration) return unreadable(calibration.error());
    job.calibration = std::move(calibration).value();
  } else if (job.config.camera.fx > 0.0) {
    job.calibration.camera = job.config.camera;
    job.calibration.origin = "the config";
  } else {
    return usage(
        "no calibration lies beside the source: give one with -c FILE, a preset "
        "name, or -c fov:DEG for a first look (docs/calibration.md)");
  }
  if (auto failure = fitSize(job.source.frames->info(), job.calibration)) return failure;
  job.config.camera = job.calibration.camera;
  for (const std::string& setting : job.options.settings) {
    if (setting.rfind("camera.", 0) == 0) applySetting(job.config, setting);
  }
  job.log.note("calibration: " + job.calibration.origin);
  return std::nullopt;
}

std::optional<Failure> openGroundTruth(Job& job) {
  job.truth_file = job.options.groundtruth ? job.options.groundtruth : job.source.groundtruth;
  if (job.truth_file) {
    Result<GroundTruth> truth = readGroundTruth(*job.truth_file);
    if (!truth) return unreadable(truth.error());
    job.truth = std::move(truth).value();
    job.log.note(fmt::format(
        "ground truth: {} ({} poses)", job.truth_file->string(), job.truth->poses.size()));
    if (job.truth->rig == RigFrame::body && !job.calibration.T_body_cam) {
      job.log.say(
          "the calibration has no T_BS: the body of the ground truth is taken as the camera");
    }
  }
  if (job.options.trajectory_frame == TrajectoryFrame::camera) return std::nullopt;
  if (!job.calibration.T_body_cam)
    return usage("--trajectory-frame body: no T_BS in the calibration");
  if (!job.truth) {
    return usage(
        "--trajectory-frame body needs ground truth: T_BS is in metres, a monocular "
        "trajectory is not");
  }
  return std::nullopt;
}

/// For pictures all of them, for the map's colours the indirect ones, unless --set says which.
void reportPoints(const Options& options, Config& config) {
  for (const std::string& setting : options.settings) {
    if (setting.rfind("tracked_points=", 0) == 0) return;
  }
  if (options.render || options.viewer) {
    config.tracked_points = ReportPoints::on;
  } else if (config.tracked_points == ReportPoints::off) {
    config.tracked_points = ReportPoints::indirect;
  }
}

std::string timeStamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local);
  return text;
}

}  // namespace

std::optional<Failure> buildConfig(Job& job) {
  if (job.options.config_file) {
    const Status status = applyConfigFile(*job.options.config_file, job.config);
    if (!status) return unreadable(status.error());
  }
  for (const std::string& setting : job.options.settings) {
    const Status status = applySetting(job.config, setting);
    if (!status) return usage(status.error().message);
  }
  Config with_camera = job.config;  // the real one is not known yet
  with_camera.camera = calibrationPreset("freiburg3")->camera;
  const Status valid = validate(with_camera);
  if (!valid) return usage(valid.error().message);
  return std::nullopt;
}

std::optional<Failure> openInputs(Job& job) {
  if (auto failure = openFrames(job)) return failure;
  if (auto failure = openCalibration(job)) return failure;
  return openGroundTruth(job);
}

std::optional<Failure> startSession(Job& job) {
  const Options& options = job.options;
  reportPoints(options, job.config);
  const Status valid = validate(job.config);
  if (!valid) {
    return Failure{kUnreadableInput, job.calibration.origin + ": " + valid.error().message};
  }
  Stopwatch watch;
  Result<GlBackend> gl = GlBackend::create(
      {job.config.backend, options.input, options.render.has_value(), options.viewer});
  if (!gl) return Failure{kNoGl, gl.error().message};
  job.gl.emplace(std::move(gl).value());
  Config config = job.config;
  config.backend = job.gl->sessionBackend();
  Result<Session> session = Session::create(config);
  if (!session) {
    const bool is_gl = job.config.backend == Backend::gles;
    return Failure{is_gl ? kNoGl : kUnreadableInput, session.error().message};
  }
  job.session.emplace(std::move(session).value());
  job.run.startup_ms = watch.lapMs();
  job.run.backend = job.session->backend();
  return std::nullopt;
}

std::optional<Failure> openOutput(Job& job) {
  const std::string name = job.source.frames->info().name;
  job.output =
      job.options.output.value_or(std::filesystem::path("out") / (name + "-" + timeStamp()));
  std::error_code fault;
  std::filesystem::create_directories(job.output, fault);
  if (fault) return usage(job.output.string() + ": cannot be made: " + fault.message());
  const Status log = job.log.open(job.output / "log.txt");
  if (!log) return usage(log.error().message);
  return std::nullopt;
}

}  // namespace glide::replay
