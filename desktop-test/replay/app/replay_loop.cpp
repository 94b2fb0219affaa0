#include "replay/app/replay_loop.h"

#include "replay/common/text.h"

#include "base/stopwatch.h"

#include "glide/enum_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace glide::replay {
namespace {

/// One line per change of state: the story of the run.
void noteStateChange(const FrameRecord& record, TrackingState before, RunLog& log) {
  const FrameResult& frame = record.result;
  if (frame.state == before) return;
  std::string line = fmt::format(
      "frame {} ({} s): {}", record.index, secondsText(frame.t_ns), enumName(frame.state));
  if (frame.state == TrackingState::tracking) {
    line += fmt::format(" by the {} tracker, {} of {} landmarks agree",
                        enumName(frame.tracker),
                        frame.stats.inliers,
                        frame.stats.visible);
  } else if (frame.state == TrackingState::initializing) {
    line += frame.initialization.status == InitializationStatus::done
                ? ", the first map is being built"
                : ", the map was too small to find again and is started over";
  } else {
    line += fmt::format(", direct tracker refused by {}", enumName(frame.switch_reason));
  }
  log.note(line);
}

void noteCorrection(const FrameRecord& record, RunLog& log) {
  const FrameResult& frame = record.result;
  if (!frame.correction) return;
  log.note(
      fmt::format("frame {} ({} s): the map was corrected, which moved the camera by {:.4g} and "
                  "turned it by {:.3g} deg, scale {:.4g}",
                  record.index,
                  secondsText(frame.t_ns),
                  frame.correction->translation,
                  frame.correction->rotation_deg,
                  frame.correction->scale));
}

using Watchers = std::vector<std::unique_ptr<FrameObserver>>;

Status showTo(const Watchers& watchers, const FrameMoment& moment) {
  for (const auto& watcher : watchers) {
    const Status status = watcher->onFrame(moment);
    if (!status) return status;
  }
  return Unit{};
}

bool areContent(const Watchers& watchers) {
  return std::any_of(
      watchers.begin(), watchers.end(), [](const auto& one) { return one->wantsToStop(); });
}

Error refused(const Error& error) {
  return {error.code, "the session refused a frame: " + error.message};
}

}  // namespace

Status replayFrames(FrameFeed& feed,
                    const Player& player,
                    const LoopObservers& observers,
                    RunRecord& run) {
  Stopwatch wall;
  TrackingState state = TrackingState::initializing;
  while (const std::optional<FedFrame> fed = feed.next()) {
    const Result<FrameInput> input = player.input.make(fed->frame.t_ns, fed->frame.image);
    if (!input) return input.error();
    Result<FrameResult> result = player.session.update(*input);
    if (!result) return refused(result.error());
    run.frames.push_back({fed->index, std::move(result).value()});
    const FrameRecord& record = run.frames.back();
    if (record.result.stats.keyframe && run.pace == Pace::lossless) player.session.waitForMapping();
    noteStateChange(record, state, observers.log);
    noteCorrection(record, observers.log);
    state = record.result.state;
    observers.progress.show(record, player.session);
    const auto before = std::chrono::steady_clock::now();
    const Status watched = showTo(observers.watchers, {record, fed->frame, player.session});
    if (!watched) return watched;
    feed.excuse(std::chrono::steady_clock::now() - before);
    if (areContent(observers.watchers)) break;
  }
  player.session.waitForMapping();
  run.wall_s = wall.lapMs() * 1e-3;
  run.dropped = feed.dropped();
  run.interrupted = feed.wasInterrupted();
  run.map = player.session.map();
  return Unit{};
}

}  // namespace glide::replay
