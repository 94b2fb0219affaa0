#pragma once

#include "replay/app/app_input.h"
#include "replay/app/progress_display.h"
#include "replay/app/run_log.h"
#include "replay/outputs/frame_observer.h"
#include "replay/readers/frame_source.h"

#include "glide/result.h"
#include "glide/session.h"

#include <memory>
#include <vector>

namespace glide::replay {

/// What the frames are given to, and how.
struct Player {
  Session& session;
  AppInput& input;
};

/// What the loop tells while it runs.
struct LoopObservers {
  RunLog& log;
  ProgressDisplay& progress;
  const std::vector<std::unique_ptr<FrameObserver>>& watchers;
};

/// Feeds every frame of the source to the session at run.pace and fills run.frames, dropped, map,
/// skips and wall_s. An error when a watcher has one, the GL has no such input, and when the
/// session refuses a frame, which is a bug or a full memory.
Status replayFrames(FrameSource& source,
                    const Player& player,
                    const LoopObservers& observers,
                    RunRecord& run);

}  // namespace glide::replay
