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

bool AppSession::isTracking() const { return last_.state == TrackingState::tracking; }

const MapView& AppSession::currentMap() {
  if (!map_ || map_->revision < last_.map_revision) map_ = session_.map();
  return *map_;
}

glide_status AppSession::setMetricScale(double metres_per_unit) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!isTracking()) return refuseUntracked();
  world_.scaleBy(metres_per_unit);
  return kDone;
}

glide_status AppSession::setGravity(const Vec3d& down_cam) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!isTracking()) return refuseUntracked();
  world_.level(T_world_cam(), down_cam);
  return kDone;
}

glide_status AppSession::setDisplay(const Display& display) {
  const std::lock_guard<std::mutex> lock(mutex_);
  display_ = display;
  return kDone;
}

glide_status AppSession::viewMatrix(float* matrix) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const SE3d T_display_cam{Eigen::Quaterniond(viewRotation(display_)), Vec3d::Zero()};
  copyMatrix((T_display_cam * world_.cameraToGl(T_world_cam()).inverse()).matrix(), matrix);
  return kDone;
}

glide_status AppSession::projectionMatrix(const ClipPlanes& planes, float* matrix) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  copyMatrix(glide::projectionMatrix(camera_, display_, planes), matrix);
  return kDone;
}

CameraModel AppSession::mapCamera() {
  const std::optional<CameraIntrinsics>& corrected = currentMap().corrected_camera;
  if (!corrected) return camera_;
  const Result<CameraModel> camera = CameraModel::create(*corrected);
  return camera ? *camera : camera_;
}

std::vector<VisiblePoint> AppSession::visible() {
  if (!isTracking()) return {};
  return visiblePoints(currentMap(), mapCamera(), T_world_cam().inverse());
}

std::vector<glide_point> AppSession::pointCloud() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<glide_point> points;
  for (const VisiblePoint& point : visible())
    points.push_back(toC(map_->landmarks[point.index], world_));
  return points;
}

std::vector<glide_hit> AppSession::hitTest(const Vec2d& uv) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<glide_hit> hits;
  for (const SurfaceHit& hit : glide::hitTest(visible(), mapCamera(), uv)) {
    // The hit's own axes are a camera's: its up becomes the app's up.
    const SE3d T_app_hit = world_.cameraToApp(T_world_cam() * hit.T_cam_hit);
    hits.push_back({toC(T_app_hit), static_cast<float>(world_.scale() * hit.distance), hit.points});
  }
  return hits;
}

glide_status AppSession::createAnchor(const glide_pose& pose, std::uint64_t* id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (last_.state == TrackingState::initializing)
    return refuse(GLIDE_ERROR_NOT_TRACKING, "there is no map to hang an anchor on");
  const std::optional<std::uint64_t> made =
      anchors_.create(world_.objectFromApp(fromC(pose)), currentMap());
  if (!made) return refuse(GLIDE_ERROR_NOT_TRACKING, "there is no map to hang an anchor on");
  *id = *made;
  return kDone;
}

glide_status AppSession::anchor(std::uint64_t id, glide_anchor* state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  anchors_.follow(currentMap());
  const std::optional<Anchors::State> found = anchors_.state(id);
  if (!found) return refuse(GLIDE_ERROR_INVALID_ARGUMENT, "there is no such anchor");
  glide_anchor result{};
  result.tracking = found->is_tracked ? 1 : 0;
  result.pose = toC(world_.objectToApp(found->T_world_anchor));
  result.revision = found->revision;
  writeSized(result, state);
  return kDone;
}

glide_status AppSession::destroyAnchor(std::uint64_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (anchors_.destroy(id)) return kDone;
  return refuse(GLIDE_ERROR_INVALID_ARGUMENT, "there is no such anchor");
}

}  // namespace glide
