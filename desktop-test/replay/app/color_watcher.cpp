#include "replay/app/color_watcher.h"

#include <span>

namespace glide::replay {

Status ColorWatcher::onFrame(const FrameMoment& moment) {
  const FrameResult& result = moment.record.result;
  std::span<const TrackedPoint> points;
  // The indirect tracker's features lie on their corners; direct points follow the pose.
  if (result.tracker == TrackerKind::indirect) points = moment.session.trackedPoints();
  colors_.add(result.map_generation, moment.frame, points);
  return Unit{};
}

}  // namespace glide::replay
