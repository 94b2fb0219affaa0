#include "vit/vit_tracker.h"

#include "vit/vit_features.h"

#include "geometry/pose_conversion.h"

#include "glide/config_text.h"

#include <chrono>
#include <exception>
#include <fstream>
#include <string>
#include <utility>

using glide::SE3d;
using glide::Vec3d;
using glide::VitFrame;

namespace {

constexpr double kNsPerMs = 1e6;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Lines "direct.patch_size=11"; blank ones and those that begin with # are skipped.
glide::Status readSettings(const char* path, glide::Config* config) {
  std::ifstream file(path);
  if (!file) return glide::Error{glide::ErrorCode::io, std::string("cannot read ") + path};
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    glide::Status set = glide::applySetting(*config, line);
    if (!set) return set;
  }
  return glide::Unit{};
}

/// OpenCV's world (x right, y down, z forward) to z up: x right, y forward.
SE3d zUpFromCv() {
  constexpr double kHalf = 0.70710678118654752440;
  return {Eigen::Quaterniond(kHalf, -kHalf, 0.0, 0.0), Vec3d::Zero()};
}

vit_pose_data toData(std::int64_t t_ns, const SE3d& T) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {t_ns,
          f(T.t.x()),
          f(T.t.y()),
          f(T.t.z()),
          f(T.q.x()),
          f(T.q.y()),
          f(T.q.z()),
          f(T.q.w()),
          0.0F,
          0.0F,
          0.0F};
}

}  // namespace

glide::Result<std::unique_ptr<vit_tracker>> vit_tracker::create(const vit_config& config) {
  std::unique_ptr<vit_tracker> tracker(new vit_tracker());
  tracker->config_.backend = glide::Backend::cpu;
  if (config.file == nullptr || *config.file == '\0') return tracker;
  const glide::Status read = readSettings(config.file, &tracker->config_);
  if (!read) return read.error();
  if (tracker->config_.backend != glide::Backend::cpu)
    return glide::Error{glide::ErrorCode::unsupported, "a runtime gives no GL context"};
  return tracker;
}

vit_result vit_tracker::addCamera(const vit_camera_calibration& calibration) {
  if (isRunning() || !enabled_.has_add_camera_calibration) return VIT_ERROR_NOT_ENABLED;
  if (calibration.camera_index > 0) return VIT_ERROR_NOT_SUPPORTED;  // monocular
  glide::Result<glide::VitCamera> camera = glide::toCamera(calibration);
  if (!camera) {
    return camera.error().code == glide::ErrorCode::unsupported ? VIT_ERROR_NOT_SUPPORTED
                                                                : VIT_ERROR_INVALID_VALUE;
  }
  camera_ = *std::move(camera);
  config_.camera = camera_->intrinsics;
  return VIT_SUCCESS;
}

vit_result vit_tracker::start() {
  if (isRunning()) return VIT_SUCCESS;
  if (!glide::validate(config_).ok()) return VIT_ERROR_INVALID_VALUE;
  velocity_.forget();
  auto sequence = std::make_shared<Sequence>();
  sequence->width = config_.camera.width;
  sequence->height = config_.camera.height;
  worker_ =
      std::make_unique<glide::Worker>("glide-vit", [this, sequence] { run(&sequence->frames); });
  const std::lock_guard<std::mutex> lock(mutex_);
  sequence_ = std::move(sequence);
  return VIT_SUCCESS;
}

vit_result vit_tracker::stop() {
  const std::shared_ptr<Sequence> sequence = this->sequence();
  if (sequence == nullptr) return VIT_SUCCESS;
  sequence->frames.close();
  worker_.reset();  // joins
  poses_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  sequence_.reset();
  return VIT_SUCCESS;
}

std::shared_ptr<vit_tracker::Sequence> vit_tracker::sequence() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return sequence_;
}

vit_result vit_tracker::reset() {
  poses_.clear();  // of the map that goes; run() notices
  return VIT_SUCCESS;
}

vit_result vit_tracker::pushImage(const vit_img_sample& sample) {
  const std::shared_ptr<Sequence> sequence = this->sequence();
  if (sequence == nullptr) return VIT_ERROR_NOT_ENABLED;
  if (sample.cam_index > 0) return VIT_SUCCESS;  // monocular: other cameras are not looked at
  if (sample.timestamp <= sequence->last_image_ns) return VIT_ERROR_INVALID_VALUE;
  const bool has_size = static_cast<int>(sample.width) == sequence->width &&
                        static_cast<int>(sample.height) == sequence->height;
  if (!has_size) return VIT_ERROR_INVALID_VALUE;
  std::optional<glide::ImageU8> luma = glide::toLuma(sample);
  if (!luma) return VIT_ERROR_INVALID_VALUE;
  sequence->last_image_ns = sample.timestamp;
  VitFrame frame{sample.timestamp, now_ns(), *std::move(luma)};
  sequence->frames.tryPush(frame);  // one that finds no room is dropped, as a camera's would be
  return VIT_SUCCESS;
}

vit_result vit_tracker::pushImu(const vit_imu_sample& sample) {
  const std::shared_ptr<Sequence> sequence = this->sequence();
  if (sequence == nullptr) return VIT_ERROR_NOT_ENABLED;
  if (sample.timestamp <= sequence->last_imu_ns) return VIT_ERROR_INVALID_VALUE;
  sequence->last_imu_ns = sample.timestamp;  // monocular: the sample itself is not used
  return VIT_SUCCESS;
}

void vit_tracker::run(FrameQueue* frames) {
  glide::Result<glide::Session> session = glide::Session::create(config_);
  if (!session) return;  // start() has validated the config: the machine is out of memory
  std::uint64_t era = poses_.era();
  while (const std::optional<VitFrame> frame = frames->pop()) {
    try {
      if (const std::uint64_t now = poses_.era(); now != era) {  // reset() was called
        session->reset();
        velocity_.forget();
        era = now;
      }
      if (std::unique_ptr<vit_pose> pose = track(*frame, &*session))
        poses_.push(std::move(pose), era);
    } catch (const std::exception&) {
      velocity_.forget();  // out of memory: this frame has no pose, the next one may
    }
    frames->done();
  }
}

std::unique_ptr<vit_pose> vit_tracker::track(const VitFrame& frame, glide::Session* session) {
  const glide::ImageU8& image = frame.luma;
  const glide::Luma luma{image.row(0), image.width(), image.height(), image.stride()};
  const glide::Result<glide::FrameResult> result = session->update({frame.t_ns, luma});
  if (!result || result->state != glide::TrackingState::tracking) {
    velocity_.forget();
    return nullptr;
  }
  return toVitPose(frame, *result, *session);
}

std::unique_ptr<vit_pose> vit_tracker::toVitPose(const VitFrame& frame,
                                                 const glide::FrameResult& result,
                                                 const glide::Session& session) {
  auto pose = std::make_unique<vit_pose>();
  const SE3d T_world_cam = glide::fromPose(result.T_world_cam);
  const SE3d T_cam_imu = camera_ ? camera_->T_imu_cam.inverse() : SE3d{};
  pose->data = toData(frame.t_ns, zUpFromCv() * T_world_cam * T_cam_imu);
  velocity_.add(result, &pose->data);
  pose->has_timing = enabled_.has_pose_timing;
  pose->has_features = enabled_.has_pose_features;
  if (pose->has_features) {
    const std::shared_ptr<const glide::MapView> map = session.frameMap()->view();
    pose->features = glide::visibleFeatures(*map, config_.camera, T_world_cam.inverse());
  }
  const auto update_ns = static_cast<std::int64_t>(result.stats.update_ms * kNsPerMs);
  const std::int64_t known_ns = now_ns();
  pose->timestamps = {frame.pushed_ns, known_ns - update_ns, known_ns};
  return pose;
}

std::unique_ptr<vit_pose> vit_tracker::popPose() { return poses_.pop(); }

vit_result vit_tracker::enable(vit_extension extension, bool enable) {
  if (isRunning()) return VIT_ERROR_NOT_ENABLED;
  switch (extension) {
    case VIT_EXTENSION_ADD_CAMERA_CALIBRATION:
      enabled_.has_add_camera_calibration = enable;
      return VIT_SUCCESS;
    case VIT_EXTENSION_ADD_IMU_CALIBRATION:
      enabled_.has_add_imu_calibration = enable;
      return VIT_SUCCESS;
    case VIT_EXTENSION_POSE_TIMING:
      enabled_.has_pose_timing = enable;
      return VIT_SUCCESS;
    case VIT_EXTENSION_POSE_FEATURES:
      enabled_.has_pose_features = enable;
      return VIT_SUCCESS;
  }
  return VIT_ERROR_NOT_SUPPORTED;
}

vit_extension_set vit_tracker::enabled() const { return enabled_; }
