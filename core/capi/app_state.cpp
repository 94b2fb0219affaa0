#include "capi/app_state.h"

#include "geometry/pose_conversion.h"

namespace glide {

SE3d AppState::T_world_cam() const { return fromPose(last.T_world_cam); }

AppWorld AppState::worldOf(std::uint64_t generation) const {
  AppWorld shown = world;
  if (generation != last.map_generation) shown.reset();
  return shown;
}

void AppState::replaceMap() {
  world.reset();
  last = FrameResult{};
  tracked_points.clear();
}

void AppState::take(const FrameResult& result, const std::vector<TrackedPoint>& points) {
  world = worldOf(result.map_generation);
  last = result;
  tracked_points = points;
}

}  // namespace glide
