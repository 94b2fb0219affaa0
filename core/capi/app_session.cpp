#include "capi/app_session.h"

#include "capi/conversion.h"
#include "capi/sized_struct.h"
#include "capi/status.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace glide {
namespace {

// Ten seconds at the highest rate of phones, 500 Hz: more than a frame will ever ask for.
constexpr std::size_t kMostImuSamples = 5000;

bool isSame(const BackendInfo& a, const BackendInfo& b) {
  return a.backend == b.backend && a.vendor == b.vendor && a.renderer == b.renderer &&
         a.version == b.version;
}

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
      state_(std::make_shared<const AppState>(AppState{
          AppWorld(config.axes == GLIDE_AXES_GL ? AppAxes::gl : AppAxes::cv), {}, {}, {}, {}})),
      backend_(std::make_shared<const BackendInfo>(session.backend())),
      session_(std::move(session)) {}

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
  const bool is_texture = !std::holds_alternative<Luma>(input->image);
  if (has_context && (is_texture || session_.backend().backend == Backend::gles))
    gl_thread_ = std::this_thread::get_id();
  if (!isSame(session_.backend(), *backend_.load()))
    backend_.store(std::make_shared<const BackendInfo>(session_.backend()));
  if (!result) {
    log(GLIDE_LOG_ERROR, result.error().message);
    return refuse(result.error());
  }
  return answer(*result, frame);
}

glide_status AppSession::answer(const FrameResult& result, glide_frame* frame) {
  const std::shared_ptr<const AppState> before = state_.load();
  changeState([&](AppState* state) {
    state->take(result, session_.frameMap(), session_.trackedPoints());
    writeSized(toC(state->last, state->world), frame);
    return kDone;
  });
  logFrame(before->last, state_.load()->last);
  return kDone;
}

void AppSession::logFrame(const FrameResult& before, const FrameResult& result) const {
  if (result.state != before.state) {
    log(GLIDE_LOG_INFO,
        result.state == TrackingState::tracking ? "tracking"
        : result.state == TrackingState::lost   ? "lost"
                                                : "initializing");
  }
  if (result.correction) log(GLIDE_LOG_INFO, "the map was corrected");
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
  changeState([](AppState* state) {
    state->replaceMap();
    return kDone;
  });
}

void AppSession::waitForMapping() { session_.waitForMapping(); }

BackendInfo AppSession::backend() const { return *backend_.load(); }

glide_status AppSession::pushImu(const glide_imu_sample* samples, std::size_t count) {
  const std::lock_guard<std::mutex> lock(imu_mutex_);
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
  const std::shared_ptr<const AppState> state = state_.load();
  const LocatedCamera located = session_.locate(t_ns);
  return toC(located, state->worldOf(located.map_generation));
}

std::shared_ptr<const AppSession::AppMap> AppSession::map() const {
  const std::shared_ptr<const AppState> state = state_.load();
  std::shared_ptr<const MapView> view = session_.map();
  const AppWorld world = state->worldOf(view->generation);
  return std::make_shared<const AppMap>(AppMap{std::move(view), world});
}

std::shared_ptr<const AppSession::AppMap> AppSession::frameMap() const {
  const std::shared_ptr<const AppState> state = state_.load();
  return std::make_shared<const AppMap>(AppMap{state->mapView(), state->world});
}

Result<std::vector<std::byte>> AppSession::saveMap() const { return session_.saveMap(); }

Status AppSession::saveMap(const char* path) const { return session_.saveMap(path); }

Status AppSession::loadMap(const char* path) {
  const Result<Session::MapFile> file = Session::MapFile::read(path);
  if (!file) return file.error();
  Status taken = takeMap(*file);
  if (!taken) return Error{taken.error().code, std::string(path) + ": " + taken.error().message};
  session_.waitForMapping();
  return taken;
}

Status AppSession::loadMap(std::span<const std::byte> bytes) {
  const Result<Session::MapFile> file = Session::MapFile::decode(bytes);
  if (!file) return file.error();
  Status taken = takeMap(*file);
  if (taken) session_.waitForMapping();
  return taken;
}

Status AppSession::takeMap(const Session::MapFile& file) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Status taken = session_.takeMap(file);
  if (!taken) return taken;
  changeState([](AppState* state) {
    state->replaceMap();
    return kDone;
  });
  return taken;
}

}  // namespace glide
