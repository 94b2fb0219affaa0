#include "replay/app/render_watchers.h"

#if defined(GLIDE_GLES)
#include "replay/app/interrupt.h"
#include "replay/evaluation/evaluate.h"
#include "replay/render/live_viewer.h"
#include "replay/render/video_recorder.h"

#include <utility>
#endif

namespace glide::replay {

#if defined(GLIDE_GLES)
namespace {

SplitViewSetup viewSetup(const Job& job) {
  SplitViewSetup setup;
  setup.camera = job.config.camera;
  setup.frames = job.source.frames->info().frames;
  setup.view = job.options.render_view;
  if (job.truth) {
    setup.truth = truthInFrame(*job.truth, RigFrame::camera, job.calibration.T_body_cam);
  }
  return setup;
}

std::optional<Failure> add(Job& job,
                           const std::string& option,
                           Result<std::unique_ptr<FrameObserver>> watcher) {
  if (watcher) {
    job.watchers.push_back(std::move(*watcher));
    return std::nullopt;
  }
  const bool is_gl = watcher.error().code == ErrorCode::unsupported;
  return Failure{is_gl ? kNoGl : kUsage, option + ": " + watcher.error().message};
}

}  // namespace

std::optional<Failure> addVideoWatcher(Job& job) {
  if (!job.options.render) return std::nullopt;
  const auto tell = [&log = job.log](const std::string& line) { log.say(line); };
  return add(job, "--render", VideoRecorder::create({*job.options.render, viewSetup(job), tell}));
}

std::optional<Failure> addViewerWatcher(Job& job) {
  if (!job.options.viewer) return std::nullopt;
  return add(
      job, "--viewer", LiveViewer::create({*job.gl->window(), viewSetup(job), isInterrupted}));
}
#else
// GlBackend has refused both options.
std::optional<Failure> addVideoWatcher(Job&) { return std::nullopt; }
std::optional<Failure> addViewerWatcher(Job&) { return std::nullopt; }
#endif

}  // namespace glide::replay
