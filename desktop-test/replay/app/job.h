#pragma once

#include "replay/app/gl_backend.h"
#include "replay/app/options.h"
#include "replay/app/run_log.h"
#include "replay/calibration/calibration.h"
#include "replay/evaluation/accuracy.h"
#include "replay/evaluation/trajectory.h"
#include "replay/outputs/frame_observer.h"
#include "replay/outputs/point_colors.h"
#include "replay/outputs/run_trajectories.h"
#include "replay/readers/open_source.h"

#include "glide/session.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glide::replay {

/// Why a replay ends early, and with which status.
struct Failure {
  ExitCode code = kUnreadableInput;
  std::string message;
};

/// One replay on its way through the steps below. The session dies before its GL context.
struct Job {
  Options options;
  RunLog log;
  Config config;
  OpenedSource source;
  Calibration calibration;
  std::optional<std::filesystem::path> truth_file;
  std::optional<GroundTruth> truth;
  std::optional<GlBackend> gl;
  std::optional<Session> session;
  std::filesystem::path output;
  RunRecord run;
  RunTrajectories trajectories;
  Estimates written;  ///< the trajectories in the frame that --trajectory-frame asks for
  std::optional<Accuracy> accuracy;
  PointColors colors;                                    ///< of the landmarks
  std::optional<Error> watcher_fault;                    ///< of the first that had to be taken out
  std::vector<std::unique_ptr<FrameObserver>> watchers;  ///< die first: they may use the GL context
};

/// The steps of a replay in their order; each says why it cannot be done.
std::optional<Failure> buildConfig(Job& job);
std::optional<Failure> openInputs(Job& job);
std::optional<Failure> startSession(Job& job);
std::optional<Failure> openOutput(Job& job);
std::optional<Failure> loadMap(Job& job);
std::optional<Failure> makeWatchers(Job& job);
std::optional<Failure> runFrames(Job& job);
std::optional<Failure> saveMap(Job& job);
std::optional<Failure> evaluateRun(Job& job);
std::optional<Failure> writeOutputs(Job& job);

/// The verdict on a run that wrote its files: never initialised, too little tracked, or nothing.
std::optional<Failure> judgeRun(const Job& job);

}  // namespace glide::replay
