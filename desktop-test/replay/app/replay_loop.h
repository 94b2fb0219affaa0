#pragma once

#include "replay/app/app_input.h"
#include "replay/app/frame_feed.h"
#include "replay/app/progress_display.h"
#include "replay/app/run_log.h"
#include "replay/outputs/frame_observer.h"

#include "glide/result.h"
#include "glide/session.h"

#include <memory>
#include <optional>
#include <vector>

namespace glide::replay {

/// What the frames are given to, and how.
struct Player {
  Session& session;
  AppInput& input;
};

/// What the loop tells while it runs. A watcher that fails is taken out; the first such error is
/// kept.
struct LoopObservers {
  RunLog& log;
  ProgressDisplay& progress;
  std::vector<std::unique_ptr<FrameObserver>>& watchers;
  std::optional<Error>& watcher_fault;
};

/// Gives every frame of the feed to the session and fills run.frames, dropped, interrupted, map and
/// wall_s. An error when the GL has no such input, and when the session refuses a frame, which is a
/// bug or a full memory.
Status replayFrames(FrameFeed& feed,
                    const Player& player,
                    const LoopObservers& observers,
                    RunRecord& run);

}  // namespace glide::replay
