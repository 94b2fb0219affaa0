#pragma once

#include "ar/anchors.h"
#include "ar/app_world.h"
#include "ar/display.h"
#include "ar/surfaces.h"

#include "geometry/pose_conversion.h"

#include "glide/glide_types.h"
#include "glide/session.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

namespace glide {

/// The session behind a glide_session: the C++ session and what an app that draws needs besides.
/// Every function may be called from any thread; calls take turns.
class AppSession {
 public:
  static Result<std::shared_ptr<AppSession>> create(const glide_config& config);
  ~AppSession();

  glide_status update(const glide_image& image, glide_frame* frame);
  glide_status releaseGl();
  void abandonGl();
  void pause();
  void resume();
  void reset();
  void waitForMapping();
  BackendInfo backend() const;

  glide_status pushImu(const glide_imu_sample* samples, std::size_t count);
  glide_location locate(std::int64_t t_ns) const;

  glide_status setMetricScale(double metres_per_unit);
  glide_status setGravity(const Vec3d& down_cam);
  glide_status setDisplay(const Display& display);
  /// Column-major, whatever the axes of poses.
  glide_status viewMatrix(float* matrix) const;
  glide_status projectionMatrix(const ClipPlanes& planes, float* matrix) const;

  std::vector<glide_point> pointCloud();
  std::vector<glide_hit> hitTest(const Vec2d& uv);

  glide_status createAnchor(const glide_pose& pose, std::uint64_t* id);
  glide_status anchor(std::uint64_t id, glide_anchor* state);
  glide_status destroyAnchor(std::uint64_t id);

  /// A map as the app sees it.
  struct AppMap {
    std::shared_ptr<const MapView> view;
    AppWorld world;
  };
  std::shared_ptr<const AppMap> map();
  Result<std::vector<std::byte>> saveMap() const;
  Status saveMap(const char* path) const;
  Status loadMap(const char* path);
  Status loadMap(std::span<const std::byte> bytes);

 private:
  AppSession(const glide_config& config, Session session, const CameraModel& camera);

  void log(std::int32_t level, std::string_view message) const;
  void onFrame(const FrameResult& result);
  /// Another map, or none, takes the place of the present one.
  void replaceMap();
  void forgetMap();
  /// Needs the lock, as all below.
  bool isTracking() const;
  const MapView& currentMap();
  /// The one that the map's poses are of.
  CameraModel mapCamera();
  std::vector<VisiblePoint> visible();
  SE3d T_world_cam() const { return fromPose(last_.T_world_cam); }

  const glide_log_fn log_;
  void* const log_user_;
  const CameraModel camera_;
  mutable std::mutex mutex_;  ///< guards all below
  Session session_;
  AppWorld world_;
  Anchors anchors_;
  Display display_;
  FrameResult last_;
  std::shared_ptr<const MapView> map_;        ///< as asked for last
  std::optional<std::thread::id> gl_thread_;  ///< that made the GL objects
  bool is_paused_ = false;
  std::deque<glide_imu_sample> imu_;
};

}  // namespace glide
