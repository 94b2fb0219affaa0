#include "session/map_view_builder.h"

#include "geometry/pose_conversion.h"

#include <algorithm>

namespace glide {

namespace {

MapView::Keyframe viewOf(const MapSnapshot::KeyframeEntry& keyframe) {
  MapView::Keyframe view{keyframe.id.value,
                         keyframe.t_ns,
                         toPose(keyframe.T_cam_world.inverse()),
                         false,
                         keyframe.scale,
                         {}};
  for (const CovisibleKeyframe& neighbor : keyframe.neighbors)
    view.covisible.push_back(neighbor.id.value);
  return view;
}

MapView::Keyframe viewOf(const MapSnapshot::RetiredEntry& retired) {
  return {retired.id.value,
          retired.t_ns,
          toPose(retired.T_cam_world.inverse()),
          true,
          retired.scale,
          {}};
}

}  // namespace

std::shared_ptr<const MapView> buildMapView(const MapSnapshot& snapshot, const MapStamp& stamp) {
  auto view = std::make_shared<MapView>();
  view->revision = snapshot.revision();
  view->generation = stamp.generation;
  view->resets = stamp.resets;
  for (const auto& keyframe : snapshot.keyframes()) view->keyframes.push_back(viewOf(keyframe));
  for (const auto& retired : snapshot.retired()) view->keyframes.push_back(viewOf(retired));
  std::sort(view->keyframes.begin(), view->keyframes.end(), [](const auto& a, const auto& b) {
    return a.id < b.id;
  });
  for (const auto& landmark : snapshot.landmarks()) {
    const Vec3d& p = landmark.p_world;
    view->landmarks.push_back(
        {landmark.id.value, {p.x(), p.y(), p.z()}, static_cast<int>(landmark.observations.size())});
  }
  for (const LoopEdge& edge : snapshot.loops())
    view->loops.push_back({edge.newer.value, edge.older.value});
  if (const auto& camera = snapshot.correctedCamera())
    view->corrected_camera = camera->intrinsics();
  return view;
}

}  // namespace glide
