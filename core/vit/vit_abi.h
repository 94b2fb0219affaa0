#ifndef GLIDE_VIT_ABI_H
#define GLIDE_VIT_ABI_H

// The visual-inertial tracking interface 2.0.1, as XR runtimes load it: our own declarations of its
// public facts (names, order and meaning of fields, symbols). docs/vit.md says what we do with it.

#include <cstddef>
#include <cstdint>

extern "C" {

enum vit_result : std::int32_t {
  VIT_SUCCESS = 0,
  VIT_ERROR_INVALID_VERSION = -1,
  VIT_ERROR_INVALID_VALUE = -2,
  VIT_ERROR_ALLOCATION_FAILURE = -3,
  VIT_ERROR_NOT_SUPPORTED = -4,
  VIT_ERROR_NOT_ENABLED = -5
};
enum vit_image_format : std::int32_t {
  VIT_IMAGE_FORMAT_L8 = 1,
  VIT_IMAGE_FORMAT_L16 = 2,
  VIT_IMAGE_FORMAT_R8G8B8 = 3
};
enum vit_distortion : std::int32_t {
  VIT_DISTORTION_NONE,
  VIT_DISTORTION_RT4,
  VIT_DISTORTION_RT5,
  VIT_DISTORTION_RT8,
  VIT_DISTORTION_KB4
};
enum vit_extension : std::int32_t {
  VIT_EXTENSION_ADD_CAMERA_CALIBRATION,
  VIT_EXTENSION_ADD_IMU_CALIBRATION,
  VIT_EXTENSION_POSE_TIMING,
  VIT_EXTENSION_POSE_FEATURES
};

struct vit_tracker;
struct vit_pose;

struct vit_extension_set {
  bool has_add_camera_calibration, has_add_imu_calibration, has_pose_timing, has_pose_features;
};
struct vit_config {
  const char* file;
  std::uint32_t cam_count, imu_count;
  bool show_ui;
};
struct vit_imu_sample {
  std::int64_t timestamp;
  float ax, ay, az;  // m/s2
  float wx, wy, wz;  // rad/s
};
struct vit_mask {
  float x, y, w, h;
};
struct vit_img_sample {
  std::uint32_t cam_index;
  std::int64_t timestamp;
  std::uint8_t* data;
  std::uint32_t width, height, stride, size;
  vit_image_format format;
  std::uint32_t mask_count;
  vit_mask* masks;
};
struct vit_pose_data {
  std::int64_t timestamp;
  float px, py, pz;
  float ox, oy, oz, ow;
  float vx, vy, vz;
};
struct vit_pose_timing {
  std::uint32_t count;
  const std::int64_t* timestamps;
};
struct vit_pose_feature {
  std::int64_t id;
  float u, v, depth;
};
struct vit_pose_features {
  std::uint32_t count;
  const vit_pose_feature* features;
};
struct vit_timing_titles {
  std::uint32_t count;
  const char** titles;
};
struct vit_camera_calibration {
  std::uint32_t camera_index;
  int width, height;
  double frequency, fx, fy, cx, cy;
  vit_distortion model;
  std::uint32_t distortion_count;
  double distortion[32];
  double transform[16];  // row-major T_imu_cam
};
struct vit_inertial_calibration {
  double transform[9];  // row-major
  double offset[3], bias_std[3], noise_std[3];
};
struct vit_imu_calibration {
  std::uint32_t imu_index;
  double frequency;
  vit_inertial_calibration accel, gyro;
};

#if defined(__LP64__)
static_assert(sizeof(vit_extension_set) == 4);
static_assert(sizeof(vit_config) == 24);
static_assert(sizeof(vit_imu_sample) == 32);
static_assert(sizeof(vit_mask) == 16);
static_assert(sizeof(vit_img_sample) == 56);
static_assert(offsetof(vit_img_sample, data) == 16 && offsetof(vit_img_sample, format) == 40);
static_assert(offsetof(vit_img_sample, masks) == 48);
static_assert(sizeof(vit_pose_data) == 48);
static_assert(sizeof(vit_pose_timing) == 16);
static_assert(sizeof(vit_pose_feature) == 24);
static_assert(sizeof(vit_pose_features) == 16);
static_assert(sizeof(vit_timing_titles) == 16);
static_assert(sizeof(vit_camera_calibration) == 448);
static_assert(sizeof(vit_inertial_calibration) == 144);
static_assert(sizeof(vit_imu_calibration) == 304);
#endif

#define GLIDE_VIT_EXPORT __attribute__((visibility("default")))

GLIDE_VIT_EXPORT vit_result vit_api_get_version(std::uint32_t* major,
                                                std::uint32_t* minor,
                                                std::uint32_t* patch);
GLIDE_VIT_EXPORT vit_result vit_tracker_create(const vit_config* config, vit_tracker** out);
GLIDE_VIT_EXPORT void vit_tracker_destroy(vit_tracker* tracker);
GLIDE_VIT_EXPORT vit_result vit_tracker_has_image_format(const vit_tracker* tracker,
                                                         vit_image_format format,
                                                         bool* supported);
GLIDE_VIT_EXPORT vit_result vit_tracker_get_supported_extensions(const vit_tracker* tracker,
                                                                 vit_extension_set* out);
GLIDE_VIT_EXPORT vit_result vit_tracker_get_enabled_extensions(const vit_tracker* tracker,
                                                               vit_extension_set* out);
GLIDE_VIT_EXPORT vit_result vit_tracker_enable_extension(vit_tracker* tracker,
                                                         vit_extension extension,
                                                         bool enable);
GLIDE_VIT_EXPORT vit_result vit_tracker_start(vit_tracker* tracker);
GLIDE_VIT_EXPORT vit_result vit_tracker_stop(vit_tracker* tracker);
GLIDE_VIT_EXPORT vit_result vit_tracker_reset(vit_tracker* tracker);
GLIDE_VIT_EXPORT vit_result vit_tracker_is_running(const vit_tracker* tracker, bool* running);
GLIDE_VIT_EXPORT vit_result vit_tracker_push_imu_sample(vit_tracker* tracker,
                                                        const vit_imu_sample* sample);
GLIDE_VIT_EXPORT vit_result vit_tracker_push_img_sample(vit_tracker* tracker,
                                                        const vit_img_sample* sample);
GLIDE_VIT_EXPORT vit_result
vit_tracker_add_camera_calibration(vit_tracker* tracker, const vit_camera_calibration* calibration);
GLIDE_VIT_EXPORT vit_result vit_tracker_add_imu_calibration(vit_tracker* tracker,
                                                            const vit_imu_calibration* calibration);
GLIDE_VIT_EXPORT vit_result vit_tracker_pop_pose(vit_tracker* tracker, vit_pose** out);
GLIDE_VIT_EXPORT vit_result vit_tracker_get_timing_titles(const vit_tracker* tracker,
                                                          vit_timing_titles* out);
GLIDE_VIT_EXPORT void vit_pose_destroy(vit_pose* pose);
GLIDE_VIT_EXPORT vit_result vit_pose_get_data(const vit_pose* pose, vit_pose_data* out);
GLIDE_VIT_EXPORT vit_result vit_pose_get_timing(const vit_pose* pose, vit_pose_timing* out);
GLIDE_VIT_EXPORT vit_result vit_pose_get_features(const vit_pose* pose,
                                                  std::uint32_t camera,
                                                  vit_pose_features* out);
}

#endif
