#pragma once

#include "replay/app/job.h"

#include <optional>

namespace glide::replay {

/// The watcher of --render, when it is asked for.
std::optional<Failure> addVideoWatcher(Job& job);

/// The watcher of --viewer, when it is asked for.
std::optional<Failure> addViewerWatcher(Job& job);

}  // namespace glide::replay
