#include "session/snapshot_map.h"

#include "geometry/pose_conversion.h"

#include <algorithm>
#include <utility>

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

MapView viewOf(const MapSnapshot& snapshot) {
  MapView view;
  view.revision = snapshot.revision();
  for (const auto& keyframe : snapshot.keyframes()) view.keyframes.push_back(viewOf(keyframe));
  for (const auto& retired : snapshot.retired()) view.keyframes.push_back(viewOf(retired));
  std::sort(view.keyframes.begin(), view.keyframes.end(), [](const auto& a, const auto& b) {
    return a.id < b.id;
  });
  for (const auto& landmark : snapshot.landmarks()) {
    const Vec3d& p = landmark.p_world;
    view.landmarks.push_back(
        {landmark.id.value, {p.x(), p.y(), p.z()}, static_cast<int>(landmark.observations.size())});
  }
  for (const LoopEdge& edge : snapshot.loops())
    view.loops.push_back({edge.newer.value, edge.older.value});
  if (const auto& camera = snapshot.correctedCamera()) view.corrected_camera = camera->intrinsics();
  return view;
}

}  // namespace

FrameMap::~FrameMap() = default;

SnapshotMap::SnapshotMap(std::shared_ptr<const MapSnapshot> snapshot,
                         std::uint64_t generation,
                         std::uint64_t resets)
    : snapshot_(std::move(snapshot)), generation_(generation), resets_(resets) {}

std::shared_ptr<const MapView> SnapshotMap::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (view_) return view_;
  auto view = std::make_shared<MapView>(viewOf(*snapshot_));
  view->generation = generation_;
  view->resets = resets_;
  view_ = std::move(view);
  return view_;
}

}  // namespace glide
