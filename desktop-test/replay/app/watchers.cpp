#include "replay/app/job.h"
#include "replay/app/render_watchers.h"

namespace glide::replay {

std::optional<Failure> makeWatchers(Job& job) {
  if (auto failure = addVideoWatcher(job)) return failure;
  return addViewerWatcher(job);  // last: at its end it waits for a person
}

}  // namespace glide::replay
