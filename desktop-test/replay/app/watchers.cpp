#include "replay/app/color_watcher.h"
#include "replay/app/job.h"
#include "replay/app/render_watchers.h"
#include "replay/app/report_watchers.h"

#include <memory>

namespace glide::replay {

std::optional<Failure> makeWatchers(Job& job) {
  job.watchers.push_back(std::make_unique<ColorWatcher>(job.config.camera, job.colors));
  if (auto failure = addVideoWatcher(job)) return failure;
  if (auto failure = addReportWatcher(job)) return failure;
  return addViewerWatcher(job);  // last: at its end it waits for a person
}

}  // namespace glide::replay
