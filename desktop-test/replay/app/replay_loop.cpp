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

/// The poses are worth more than a picture: who cannot go on is left behind.
void showTo(const LoopObservers& observers, const FrameMoment& moment) {
  std::erase_if(observers.watchers, [&](const std::unique_ptr<FrameObserver>& watcher) {
    const Status status = watcher->onFrame(moment);
    if (status) return false;
    observers.log.say(status.error().message + ": the replay goes on without it");
    if (!observers.watcher_fault) observers.watcher_fault = status.error();
    return true;
  });
}

bool areContent(const Watchers& watchers) {
  return std::any_of(
      watchers.begin(), watchers.end(), [](const auto& one) { return one->wantsToStop(); });
}

/// The map at the end, or where it was given up and no frame was tracked in another, as it was
/// before.
std::shared_ptr<const MapView> finalMap(const std::shared_ptr<const MapView>& tracked,
                                        const std::shared_ptr<const MapView>& end) {
  if (!tracked || tracked->generation == end->generation) return end;
  const auto kept = std::make_shared<MapView>(*tracked);
  kept->resets = end->resets;
  return kept;
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
    if (state == TrackingState::tracking) run.map = player.session.map();
    observers.progress.show(record, player.session);
    const auto before = std::chrono::steady_clock::now();
    showTo(observers, {record, fed->frame, player.session});
    feed.excuse(std::chrono::steady_clock::now() - before);
    if (areContent(observers.watchers)) break;
  }
  player.session.waitForMapping();
  run.wall_s = wall.lapMs() * 1e-3;
  run.dropped = feed.dropped();
  run.interrupted = feed.wasInterrupted();
  run.map = finalMap(run.map, player.session.map());
  return Unit{};
}

}  // namespace glide::replay
