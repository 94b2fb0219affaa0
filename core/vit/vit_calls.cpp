// The 21 symbols. No exception leaves; null arguments are refused.
#include "vit/vit_tracker.h"

#include <array>
#include <new>

namespace {

// Of the interface that these functions follow.
constexpr std::uint32_t kMajor = 2, kMinor = 0, kPatch = 1;

constexpr vit_extension_set kSupported{true, true, true, true};

/// Runs a function that returns a vit_result; nothing that it throws leaves.
template <class Function>
vit_result guarded(Function&& function) noexcept {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return VIT_ERROR_ALLOCATION_FAILURE;
  } catch (...) {
    return VIT_ERROR_INVALID_VALUE;
  }
}

template <class T>
vit_result give(const T& value, T* out) {
  if (out == nullptr) return VIT_ERROR_INVALID_VALUE;
  *out = value;
  return VIT_SUCCESS;
}

}  // namespace

extern "C" {

vit_result vit_api_get_version(std::uint32_t* major, std::uint32_t* minor, std::uint32_t* patch) {
  if (major == nullptr || minor == nullptr || patch == nullptr) return VIT_ERROR_INVALID_VALUE;
  *major = kMajor;
  *minor = kMinor;
  *patch = kPatch;
  return VIT_SUCCESS;
}

vit_result vit_tracker_create(const vit_config* config, vit_tracker** out) {
  if (config == nullptr || out == nullptr) return VIT_ERROR_INVALID_VALUE;
  *out = nullptr;
  return guarded([&] {
    glide::Result<std::unique_ptr<vit_tracker>> tracker = vit_tracker::create(*config);
    if (!tracker) return VIT_ERROR_INVALID_VALUE;
    *out = tracker->release();
    return VIT_SUCCESS;
  });
}

void vit_tracker_destroy(vit_tracker* tracker) { delete tracker; }

vit_result vit_tracker_has_image_format(const vit_tracker* tracker,
                                        vit_image_format format,
                                        bool* supported) {
  if (tracker == nullptr) return VIT_ERROR_INVALID_VALUE;
  return give(format == VIT_IMAGE_FORMAT_L8 || format == VIT_IMAGE_FORMAT_R8G8B8, supported);
}

vit_result vit_tracker_get_supported_extensions(const vit_tracker* tracker,
                                                vit_extension_set* out) {
  return tracker == nullptr ? VIT_ERROR_INVALID_VALUE : give(kSupported, out);
}

vit_result vit_tracker_get_enabled_extensions(const vit_tracker* tracker, vit_extension_set* out) {
  return tracker == nullptr ? VIT_ERROR_INVALID_VALUE : give(tracker->enabled(), out);
}

vit_result vit_tracker_enable_extension(vit_tracker* tracker,
                                        vit_extension extension,
                                        bool enable) {
  return tracker == nullptr ? VIT_ERROR_INVALID_VALUE : tracker->enable(extension, enable);
}

vit_result vit_tracker_start(vit_tracker* tracker) {
  if (tracker == nullptr) return VIT_ERROR_INVALID_VALUE;
  return guarded([&] { return tracker->start(); });
}

vit_result vit_tracker_stop(vit_tracker* tracker) {
  if (tracker == nullptr) return VIT_ERROR_INVALID_VALUE;
  return guarded([&] { return tracker->stop(); });
}

vit_result vit_tracker_reset(vit_tracker* tracker) {
  return tracker == nullptr ? VIT_ERROR_INVALID_VALUE : tracker->reset();
}

vit_result vit_tracker_is_running(const vit_tracker* tracker, bool* running) {
  return tracker == nullptr ? VIT_ERROR_INVALID_VALUE : give(tracker->isRunning(), running);
}

vit_result vit_tracker_push_imu_sample(vit_tracker* tracker, const vit_imu_sample* sample) {
  if (tracker == nullptr || sample == nullptr) return VIT_ERROR_INVALID_VALUE;
  return tracker->pushImu(*sample);
}

vit_result vit_tracker_push_img_sample(vit_tracker* tracker, const vit_img_sample* sample) {
  if (tracker == nullptr || sample == nullptr) return VIT_ERROR_INVALID_VALUE;
  return guarded([&] { return tracker->pushImage(*sample); });
}

vit_result vit_tracker_add_camera_calibration(vit_tracker* tracker,
                                              const vit_camera_calibration* calibration) {
  if (tracker == nullptr || calibration == nullptr) return VIT_ERROR_INVALID_VALUE;
  return guarded([&] { return tracker->addCamera(*calibration); });
}

vit_result vit_tracker_add_imu_calibration(vit_tracker* tracker,
                                           const vit_imu_calibration* calibration) {
  if (tracker == nullptr || calibration == nullptr) return VIT_ERROR_INVALID_VALUE;
  if (!tracker->enabled().has_add_imu_calibration) return VIT_ERROR_NOT_ENABLED;
  return VIT_SUCCESS;  // monocular: there is nothing to calibrate
}

vit_result vit_tracker_pop_pose(vit_tracker* tracker, vit_pose** out) {
  if (tracker == nullptr) return VIT_ERROR_INVALID_VALUE;
  return guarded([&] {
    std::unique_ptr<vit_pose> pose = tracker->popPose();
    if (out != nullptr) *out = pose.release();  // a null argument drops one
    return VIT_SUCCESS;
  });
}

vit_result vit_tracker_get_timing_titles(const vit_tracker* tracker, vit_timing_titles* out) {
  // Fixed text: the interface wants pointers that outlive the call, and not const ones.
  static std::array<const char*, glide::kVitTimings> titles{"pushed", "tracking", "tracked"};
  if (tracker == nullptr) return VIT_ERROR_INVALID_VALUE;
  if (!tracker->enabled().has_pose_timing) return VIT_ERROR_NOT_ENABLED;
  return give({static_cast<std::uint32_t>(titles.size()), titles.data()}, out);
}

void vit_pose_destroy(vit_pose* pose) { delete pose; }

vit_result vit_pose_get_data(const vit_pose* pose, vit_pose_data* out) {
  return pose == nullptr ? VIT_ERROR_INVALID_VALUE : give(pose->data, out);
}

vit_result vit_pose_get_timing(const vit_pose* pose, vit_pose_timing* out) {
  if (pose == nullptr) return VIT_ERROR_INVALID_VALUE;
  if (!pose->has_timing) return VIT_ERROR_NOT_ENABLED;
  return give({static_cast<std::uint32_t>(pose->timestamps.size()), pose->timestamps.data()}, out);
}

vit_result vit_pose_get_features(const vit_pose* pose,
                                 std::uint32_t camera,
                                 vit_pose_features* out) {
  if (pose == nullptr || camera > 0) return VIT_ERROR_INVALID_VALUE;
  if (!pose->has_features) return VIT_ERROR_NOT_ENABLED;
  return give({static_cast<std::uint32_t>(pose->features.size()), pose->features.data()}, out);
}

}  // extern "C"
