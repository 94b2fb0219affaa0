#include "capi/app_session.h"

#include "capi/conversion.h"
#include "capi/sized_struct.h"
#include "capi/status.h"

#include <algorithm>
#include <string>
#include <utility>

namespace glide {
namespace {

// Ten seconds at the highest rate of phones, 500 Hz: more than a frame will ever ask for.
constexpr std::size_t kMostImuSamples = 5000;

}  // namespace

Result<std::shared_ptr<AppSession>> AppSession::create(const glide_config& given) {
  if (given.axes != GLIDE_AXES_GL && given.axes != GLIDE_AXES_CV)
    return Error{ErrorCode::invalid_argument, "axes is no GLIDE_AXES_*"};
  const Result<Config> config = toConfig(given);
  if (!config) return config.error();
  const Result<CameraModel> camera = CameraModel::create(config->camera);
  if (!camera) return camera.error();
  Result<Session> session = Session::create(*config);
  if (!session) return session.error();
  return std::shared_ptr<AppSession>(new AppSession(given, std::move(*session), *camera));
}

AppSession::AppSession(const glide_config& config, Session session, const CameraModel& camera)
    : log_(config.log),
      log_user_(config.log_user),
      camera_(camera),
      session_(std::move(session)),
      world_(config.axes == GLIDE_AXES_GL ? AppAxes::gl : AppAxes::cv) {}

AppSession::~AppSession() {
  if (gl_thread_ && *gl_thread_ != std::this_thread::get_id()) {
    log(GLIDE_LOG_WARNING, "destroyed on another thread than its GL objects, which are leaked");
    session_.abandonGl();
  }
}

void AppSession::log(std::int32_t level, std::string_view message) const {
  if (log_ != nullptr) log_(log_user_, level, std::string(message).c_str());
}

glide_status AppSession::update(const glide_image& image, glide_frame* frame) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_paused_) return refuse(GLIDE_ERROR_SESSION_PAUSED, "call glide_session_resume first");
  if (gl_thread_ && *gl_thread_ != std::this_thread::get_id())
    return refuse(GLIDE_ERROR_WRONG_THREAD,
                  "the thread of the first update owns the GL objects until release_gl");
  const Result<FrameInput> input = toFrameInput(image);
  if (!input) return refuse(input.error());
  const Result<FrameResult> result = session_.update(*input);
  // A refused frame may have made GL objects, too; without a context there are none.
  const bool has_context = result || result.error().code != ErrorCode::missing_context;
  if (has_context && session_.backend().backend == Backend::gles)
    gl_thread_ = std::this_thread::get_id();
  if (!result) {
    log(GLIDE_LOG_ERROR, result.error().message);
    return refuse(result.error());
  }
  onFrame(*result);
  writeSized(toC(*result, world_), frame);
  return kDone;
}

void AppSession::onFrame(const FrameResult& result) {
  const bool had_map = last_.state == TrackingState::tracking || last_.state == TrackingState::lost;
  // After the start the mapper takes a few frames to publish its map: that is none lost.
  const bool is_pending = result.initialization.status == InitializationStatus::done;
  if (had_map && result.state == TrackingState::initializing && !is_pending) forgetMap();
  if (result.state != last_.state) {
    log(GLIDE_LOG_INFO,
        result.state == TrackingState::tracking ? "tracking"
        : result.state == TrackingState::lost   ? "lost"
                                                : "initializing");
  }
  if (result.correction) log(GLIDE_LOG_INFO, "the map was corrected");
  last_ = result;
}

void AppSession::replaceMap() {
  last_ = FrameResult{};
  forgetMap();
}

void AppSession::forgetMap() {
  world_.reset();
  anchors_.loseMap();
  map_.reset();
}

glide_status AppSession::releaseGl() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (gl_thread_ && *gl_thread_ != std::this_thread::get_id())
    return refuse(GLIDE_ERROR_WRONG_THREAD,
                  "release_gl belongs on the thread that calls update, abandon_gl on any");
  session_.releaseGl();
  gl_thread_.reset();
  return kDone;
}

void AppSession::abandonGl() {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_.abandonGl();
  gl_thread_.reset();
}

void AppSession::pause() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!is_paused_) session_.pause();
  is_paused_ = true;
}

void AppSession::resume() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_paused_) session_.resume();
  is_paused_ = false;
}

void AppSession::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_.reset();
  replaceMap();
}

void AppSession::waitForMapping() {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_.waitForMapping();
}

BackendInfo AppSession::backend() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return session_.backend();
}

glide_status AppSession::pushImu(const glide_imu_sample* samples, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::int64_t last_ns = imu_.empty() ? INT64_MIN : imu_.back().t_ns;
  for (std::size_t i = 0; i < count; ++i) {
    if (samples[i].t_ns <= last_ns)
      return refuse(GLIDE_ERROR_TIMESTAMP_ORDER,
                    "IMU sample " + std::to_string(i) + " is not newer than the one before");
    last_ns = samples[i].t_ns;
  }
  imu_.insert(imu_.end(), samples, samples + count);
  if (imu_.size() > kMostImuSamples)
    imu_.erase(imu_.begin(), imu_.end() - static_cast<std::ptrdiff_t>(kMostImuSamples));
  return kDone;
}

glide_location AppSession::locate(std::int64_t t_ns) const {
  const LocatedCamera located = session_.locate(t_ns);
  const std::lock_guard<std::mutex> lock(mutex_);
  return toC(located, world_);
}

std::shared_ptr<const AppSession::AppMap> AppSession::map() {
  std::shared_ptr<const MapView> view = session_.map();
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::make_shared<const AppMap>(AppMap{std::move(view), world_});
}

Result<std::vector<std::byte>> AppSession::saveMap() const { return session_.saveMap(); }

Status AppSession::saveMap(const char* path) const { return session_.saveMap(path); }

Status AppSession::loadMap(const char* path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Status loaded = session_.loadMap(path);
  if (loaded) replaceMap();
  return loaded;
}

Status AppSession::loadMap(std::span<const std::byte> bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Status loaded = session_.loadMap(bytes);
  if (loaded) replaceMap();
  return loaded;
}

}  // namespace glide
