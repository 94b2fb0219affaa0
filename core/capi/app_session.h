#pragma once

#include "ar/anchors.h"
#include "ar/app_world.h"
#include "ar/display.h"
#include "ar/surfaces.h"
#include "capi/app_state.h"

#include "base/published.h"

#include "glide/glide_types.h"
#include "glide/session.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace glide {

/// The session behind a glide_session: the C++ session and what an app that draws needs besides.
/// Every function may be called from any thread. Those that change what update() works with take
/// turns with it (marked so); the others look at what it has published, and never wait for it.
class AppSession {
 public:
  static Result<std::shared_ptr<AppSession>> create(const glide_config& config);
  ~AppSession();

  /// These take turns.
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

  std::vector<glide_point> pointCloud() const;
  std::vector<glide_tracked_point> trackedPoints() const;
  std::vector<glide_hit> hitTest(const Vec2d& uv) const;

  glide_status createAnchor(const glide_pose& pose, std::uint64_t* id);
  glide_status anchor(std::uint64_t id, glide_anchor* state);
  glide_status destroyAnchor(std::uint64_t id);

  /// A map as the app sees it.
  struct AppMap {
    std::shared_ptr<const MapView> view;
    AppWorld world;
  };
  std::shared_ptr<const AppMap> map() const;
  /// That of the last frame.
  std::shared_ptr<const AppMap> frameMap() const;
  Result<std::vector<std::byte>> saveMap() const;
  Status saveMap(const char* path) const;
  /// Takes its turn after the file is read, and waits for the mapper after that.
  Status loadMap(const char* path);
  Status loadMap(std::span<const std::byte> bytes);

 private:
  AppSession(const glide_config& config, Session session, const CameraModel& camera);

  /// What the last frame sees of its map.
  struct Sight {
    std::shared_ptr<const AppState> state;
    std::shared_ptr<const MapView> map;
    CameraModel camera;  ///< that the map's poses are of
    std::vector<VisiblePoint> points;
  };

  void log(std::int32_t level, std::string_view message) const;
  /// Publishes and tells the result of a frame.
  glide_status answer(const FrameResult& result, glide_frame* frame);
  void logFrame(const FrameResult& before, const FrameResult& result) const;
  Status takeMap(const Session::MapFile& file);
  Sight sight() const;
  CameraModel cameraOf(const MapView& map) const;
  /// Publishes the state as change(AppState*), which returns a glide_status, leaves it; not after a
  /// failure.
  template <class Change>
  glide_status changeState(Change&& change) {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    auto next = std::make_shared<AppState>(*state_.load());
    const glide_status status = std::forward<Change>(change)(next.get());
    if (status == GLIDE_OK) state_.store(std::move(next));
    return status;
  }

  const glide_log_fn log_;
  void* const log_user_;
  const CameraModel camera_;

  // Any thread.
  Published<AppState> state_;
  Published<BackendInfo> backend_;
  std::mutex state_mutex_;  ///< of who replaces state_; held for a copy of it

  std::mutex imu_mutex_;
  std::deque<glide_imu_sample> imu_;

  std::mutex anchors_mutex_;
  Anchors anchors_;

  // By turns, but for what Session calls any thread's.
  std::mutex mutex_;
  Session session_;
  std::optional<std::thread::id> gl_thread_;  ///< that made the GL objects
  bool is_paused_ = false;
};

}  // namespace glide
