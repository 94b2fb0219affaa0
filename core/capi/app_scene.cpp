// What an app that draws asks of its session: the world, matrices, points, hits and anchors.
#include "capi/app_session.h"
#include "capi/conversion.h"
#include "capi/sized_struct.h"
#include "capi/status.h"

#include <Eigen/Core>

#include <algorithm>
#include <optional>

namespace glide {
namespace {

using Mat4f = Eigen::Matrix<float, 4, 4>;

void copyMatrix(const Mat4d& matrix, float* target) {
  const Mat4f values = matrix.cast<float>();  // column-major, as OpenGL's
  std::copy_n(values.data(), values.size(), target);
}

glide_status refuseUntracked() {
  return refuse(GLIDE_ERROR_NOT_TRACKING, "the last frame was not tracked");
}

}  // namespace

glide_status AppSession::setMetricScale(double metres_per_unit) {
  return changeState([&](AppState* state) -> glide_status {
    if (!state->isTracking()) return refuseUntracked();
    state->world.scaleBy(metres_per_unit);
    return kDone;
  });
}

glide_status AppSession::setGravity(const Vec3d& down_cam) {
  return changeState([&](AppState* state) -> glide_status {
    if (!state->isTracking()) return refuseUntracked();
    state->world.level(state->T_world_cam(), down_cam);
    return kDone;
  });
}

glide_status AppSession::setDisplay(const Display& display) {
  return changeState([&](AppState* state) {
    state->display = display;
    return kDone;
  });
}

glide_status AppSession::viewMatrix(float* matrix) const {
  const std::shared_ptr<const AppState> state = state_.load();
  const SE3d T_display_cam{Eigen::Quaterniond(viewRotation(state->display)), Vec3d::Zero()};
  const SE3d T_world_cam = state->world.cameraToGl(state->T_world_cam());
  copyMatrix((T_display_cam * T_world_cam.inverse()).matrix(), matrix);
  return kDone;
}

glide_status AppSession::projectionMatrix(const ClipPlanes& planes, float* matrix) const {
  copyMatrix(glide::projectionMatrix(camera_, state_.load()->display, planes), matrix);
  return kDone;
}

CameraModel AppSession::cameraOf(const MapView& map) const {
  if (!map.corrected_camera) return camera_;
  const Result<CameraModel> camera = CameraModel::create(*map.corrected_camera);
  return camera ? *camera : camera_;
}

AppSession::Sight AppSession::sight() const {
  const std::shared_ptr<const AppState> state = state_.load();
  Sight sight{state, state->mapView(), camera_, {}};
  if (!state->isTracking()) return sight;
  sight.camera = cameraOf(*sight.map);
  sight.points = visiblePoints(*sight.map, sight.camera, sight.state->T_world_cam().inverse());
  return sight;
}

std::vector<glide_point> AppSession::pointCloud() const {
  const Sight seen = sight();
  std::vector<glide_point> points;
  for (const VisiblePoint& point : seen.points)
    points.push_back(toC(seen.map->landmarks[point.index], seen.state->world));
  return points;
}

std::vector<glide_tracked_point> AppSession::trackedPoints() const {
  const std::shared_ptr<const AppState> state = state_.load();
  std::vector<glide_tracked_point> points;
  for (const TrackedPoint& point : state->tracked_points) points.push_back(toC(point));
  return points;
}

std::vector<glide_hit> AppSession::hitTest(const Vec2d& uv) const {
  const Sight seen = sight();
  const AppWorld& world = seen.state->world;
  std::vector<glide_hit> hits;
  for (const SurfaceHit& hit : glide::hitTest(seen.points, seen.camera, uv)) {
    // The hit's own axes are a camera's: its up becomes the app's up.
    const SE3d T_app_hit = world.cameraToApp(seen.state->T_world_cam() * hit.T_cam_hit);
    hits.push_back({toC(T_app_hit), static_cast<float>(world.scale() * hit.distance), hit.points});
  }
  return hits;
}

glide_status AppSession::createAnchor(const glide_pose& pose, std::uint64_t* id) {
  const std::lock_guard<std::mutex> lock(anchors_mutex_);
  const std::shared_ptr<const AppState> state = state_.load();
  const std::optional<std::uint64_t> made =
      anchors_.create(state->world.objectFromApp(fromC(pose)), *state->mapView());
  if (!made) return refuse(GLIDE_ERROR_NOT_TRACKING, "there is no map to hang an anchor on");
  *id = *made;
  return kDone;
}

glide_status AppSession::anchor(std::uint64_t id, glide_anchor* state) {
  const std::lock_guard<std::mutex> lock(anchors_mutex_);
  const std::shared_ptr<const AppState> seen = state_.load();
  anchors_.follow(*seen->mapView());
  const std::optional<Anchors::State> found = anchors_.state(id);
  if (!found) return refuse(GLIDE_ERROR_INVALID_ARGUMENT, "there is no such anchor");
  glide_anchor result{};
  result.tracking = found->is_tracked ? 1 : 0;
  result.pose = toC(seen->world.objectToApp(found->T_world_anchor));
  result.revision = found->revision;
  writeSized(result, state);
  return kDone;
}

glide_status AppSession::destroyAnchor(std::uint64_t id) {
  const std::lock_guard<std::mutex> lock(anchors_mutex_);
  if (anchors_.destroy(id)) return kDone;
  return refuse(GLIDE_ERROR_INVALID_ARGUMENT, "there is no such anchor");
}

}  // namespace glide
