#include "replay/app/color_watcher.h"

#include "replay/outputs/run_trajectories.h"

#include "geometry/camera_model.h"

#include <memory>
#include <span>
#include <vector>

namespace glide::replay {
namespace {

std::uint64_t pastLandmarks(const MapView& map) {
  return map.landmarks.empty() ? 0 : map.landmarks.back().id + 1;
}

}  // namespace

Status ColorWatcher::onFrame(const FrameMoment& moment) {
  const FrameResult& result = moment.record.result;
  if (map_generation_ != result.map_generation) {
    map_generation_ = result.map_generation;
    next_landmark_ = pastLandmarks(*moment.session.map());  // of a map from a file
  }
  std::span<const TrackedPoint> points;
  // The indirect tracker's features lie on their corners; direct points follow the pose.
  if (result.tracker == TrackerKind::indirect) points = moment.session.trackedPoints();
  colors_.add(result.map_generation, moment.frame, points);
  if (result.stats.keyframe) addNewLandmarks(moment);
  return Unit{};
}

void ColorWatcher::addNewLandmarks(const FrameMoment& moment) {
  const FrameResult& result = moment.record.result;
  const std::shared_ptr<const MapView> map = moment.session.map();
  // The mapper has the keyframe when the replay waits for it, and may have it otherwise.
  if (map->keyframes.empty() || map->keyframes.back().t_ns != result.t_ns) return;
  const Result<CameraModel> camera = CameraModel::create(map->corrected_camera.value_or(camera_));
  if (!camera) return;
  const SE3d T_cam_world = toSE3(map->keyframes.back().T_world_cam).inverse();
  std::vector<TrackedPoint> seen;
  for (const MapView::Landmark& landmark : map->landmarks) {
    if (landmark.id < next_landmark_) continue;
    const auto& p = landmark.p_world;
    const std::optional<Vec2d> uv = camera->project(T_cam_world * Vec3d(p[0], p[1], p[2]));
    if (!uv) continue;
    const Eigen::Vector2f pixel = uv->cast<float>();
    seen.push_back({landmark.id, pixel.x(), pixel.y(), 0.0F, true});
  }
  colors_.add(result.map_generation, moment.frame, seen);
  next_landmark_ = pastLandmarks(*map);
}

}  // namespace glide::replay
