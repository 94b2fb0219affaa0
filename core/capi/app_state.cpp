#include "capi/app_state.h"

#include "geometry/pose_conversion.h"

#include <utility>

namespace glide {

SE3d AppState::T_world_cam() const { return fromPose(last.T_world_cam); }

std::shared_ptr<const MapView> AppState::mapView() const {
  return map ? map->view() : std::make_shared<const MapView>();
}

AppWorld AppState::worldOf(std::uint64_t generation) const {
  AppWorld shown = world;
  if (generation != last.map_generation) shown.reset();
  return shown;
}

void AppState::replaceMap() {
  world.reset();
  last = FrameResult{};
  map.reset();
  tracked_points.clear();
}

void AppState::take(const FrameResult& result,
                    std::shared_ptr<const FrameMap> map_of_result,
                    const std::vector<TrackedPoint>& points) {
  world = worldOf(result.map_generation);
  last = result;
  const bool has_map = result.map_revision != 0;
  if (isTracking() && !has_map) {
    last.state = TrackingState::initializing;
    last.initialization.status = InitializationStatus::done;
    last.tracker = TrackerKind::none;
    last.confidence = 0.0;
  }
  map = std::move(map_of_result);
  tracked_points = isTracking() ? points : std::vector<TrackedPoint>{};
}

}  // namespace glide
