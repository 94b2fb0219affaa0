// What io.github.glideslam.Layout must say: a test compares.
#include "jni_guard.h"
#include "natives.h"

#include "glide/glide.h"

#include <cstddef>
#include <iterator>

namespace glide_jni {
namespace {

constexpr std::size_t kNumbers[] = {
    sizeof(glide_pose),
    offsetof(glide_pose, p),

    sizeof(glide_config),
    offsetof(glide_config, backend),
    offsetof(glide_config, mode),
    offsetof(glide_config, execution),
    offsetof(glide_config, axes),
    offsetof(glide_config, camera),

    sizeof(glide_intrinsics),
    offsetof(glide_intrinsics, width),
    offsetof(glide_intrinsics, height),
    offsetof(glide_intrinsics, fx),
    offsetof(glide_intrinsics, distortion),
    offsetof(glide_intrinsics, coefficient_count),
    offsetof(glide_intrinsics, coefficients),
    std::size(glide_intrinsics{}.coefficients),

    sizeof(glide_image),
    offsetof(glide_image, kind),
    offsetof(glide_image, t_ns),
    offsetof(glide_image, width),
    offsetof(glide_image, height),
    offsetof(glide_image, pixels),
    offsetof(glide_image, row_stride),
    offsetof(glide_image, texture),
    offsetof(glide_image, transform),
    offsetof(glide_image, exposure_ns),
    offsetof(glide_image, rolling_shutter_skew_ns),

    sizeof(glide_frame),
    offsetof(glide_frame, state),
    offsetof(glide_frame, reason),
    offsetof(glide_frame, tracker),
    offsetof(glide_frame, t_ns),
    offsetof(glide_frame, camera),
    offsetof(glide_frame, confidence),
    offsetof(glide_frame, keyframe),
    offsetof(glide_frame, map_revision),
    offsetof(glide_frame, world_corrected),
    offsetof(glide_frame, correction_distance),
    offsetof(glide_frame, correction_rotation),
    offsetof(glide_frame, correction_scale),
    offsetof(glide_frame, visible),
    offsetof(glide_frame, inliers),
    offsetof(glide_frame, update_ms),
    offsetof(glide_frame, rms),
    offsetof(glide_frame, switch_reason),
    offsetof(glide_frame, start_matches),
    offsetof(glide_frame, start_parallax_deg),
    offsetof(glide_frame, start_landmarks),
    offsetof(glide_frame, map_generation),

    sizeof(glide_location),
    offsetof(glide_location, flags),
    offsetof(glide_location, t_ns),
    offsetof(glide_location, camera),

    sizeof(glide_point),
    offsetof(glide_point, id),

    sizeof(glide_tracked_point),
    offsetof(glide_tracked_point, u),
    offsetof(glide_tracked_point, v),
    offsetof(glide_tracked_point, residual),
    offsetof(glide_tracked_point, inlier),

    sizeof(glide_keyframe),
    offsetof(glide_keyframe, t_ns),
    offsetof(glide_keyframe, camera),
    offsetof(glide_keyframe, retired),

    sizeof(glide_loop),
    offsetof(glide_loop, older),

    sizeof(glide_hit),
    offsetof(glide_hit, distance),
    offsetof(glide_hit, points),

    sizeof(glide_anchor),
    offsetof(glide_anchor, tracking),
    offsetof(glide_anchor, pose),
    offsetof(glide_anchor, revision),

    sizeof(glide_imu_sample),
    offsetof(glide_imu_sample, acceleration),
    offsetof(glide_imu_sample, angular_velocity),

    sizeof(glide_backend_info),
    offsetof(glide_backend_info, backend),
    offsetof(glide_backend_info, vendor),
    offsetof(glide_backend_info, renderer),
    offsetof(glide_backend_info, version),
};

jintArray JNICALL layout(JNIEnv* env, jclass /*type*/) {
  const jintArray result = env->NewIntArray(static_cast<jsize>(std::size(kNumbers)));
  if (result == nullptr) return nullptr;  // an OutOfMemoryError is pending
  jint at = 0;
  for (const std::size_t number : kNumbers) {
    const auto value = static_cast<jint>(number);
    env->SetIntArrayRegion(result, at++, 1, &value);
  }
  return result;
}

jstring JNICALL version(JNIEnv* env, jclass /*type*/) {
  return env->NewStringUTF(glide_version_string());  // ASCII
}

}  // namespace

std::vector<JNINativeMethod> layoutNatives() {
  return {native("layout", "()[I", layout), native("version", "()Ljava/lang/String;", version)};
}

}  // namespace glide_jni
