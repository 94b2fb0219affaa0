// What an app that draws asks: matrices, points, hits and anchors.
#include "arguments.h"
#include "jni_guard.h"
#include "natives.h"

#include "glide/glide.h"

#include <array>
#include <cstdint>

namespace glide_jni {
namespace {

using Matrix = std::array<float, 16>;

void JNICALL setMetricScale(JNIEnv* env, jclass /*type*/, jlong session, jfloat metres_per_unit) {
  guarded(env, [&] {
    return glide_session_set_metric_scale(handleOf<glide_session>(session), metres_per_unit);
  });
}

// NOLINTNEXTLINE(readability-function-size): Java has no structs to pass
void JNICALL setGravity(JNIEnv* env, jclass /*type*/, jlong session, jfloat x, jfloat y, jfloat z) {
  guarded(env, [&] {
    const std::array<float, 3> down{x, y, z};
    return glide_session_set_gravity(handleOf<glide_session>(session), down.data());
  });
}

// NOLINTNEXTLINE(readability-function-size): Java has no structs to pass
void JNICALL setDisplay(
    JNIEnv* env, jclass /*type*/, jlong session, jint rotation_deg, jint width, jint height) {
  guarded(env, [&] {
    return glide_session_set_display(handleOf<glide_session>(session), rotation_deg, width, height);
  });
}

/// A range of a Java array that a matrix is written to.
struct MatrixRange {
  jfloatArray array;
  jint offset;
};

/// Runs call(float*) and writes the matrix that it made.
template <class Call>
void giveMatrix(JNIEnv* env, const MatrixRange& target, Call&& call) {
  guarded(env, [&]() -> glide_status {
    if (target.array == nullptr) return refuse(env, "the matrix is null");
    Matrix matrix{};
    const auto size = static_cast<jint>(matrix.size());
    if (target.offset < 0 || target.offset > env->GetArrayLength(target.array) - size)
      return refuse(env, "the matrix has no 16 elements from the offset on");
    const glide_status status = call(matrix.data());
    if (status >= 0) env->SetFloatArrayRegion(target.array, target.offset, size, matrix.data());
    return status;
  });
}

void JNICALL
viewMatrix(JNIEnv* env, jclass /*type*/, jlong session, jfloatArray matrix, jint offset) {
  giveMatrix(env, {matrix, offset}, [&](float* values) {
    return glide_session_view_matrix(handleOf<glide_session>(session), values);
  });
}

// NOLINTNEXTLINE(readability-function-size): Java has no structs to pass
void JNICALL projectionMatrix(JNIEnv* env,
                              jclass /*type*/,
                              jlong session,
                              jfloat near_plane,
                              jfloat far_plane,
                              jfloatArray matrix,
                              jint offset) {
  giveMatrix(env, {matrix, offset}, [&](float* values) {
    return glide_session_projection_matrix(
        handleOf<glide_session>(session), near_plane, far_plane, values);
  });
}

jint JNICALL pointCloud(JNIEnv* env, jclass /*type*/, jlong session, jobject points) {
  return counted<glide_point>(
      env, points, [&](std::size_t capacity, glide_point* out, std::size_t* count) {
        return glide_session_point_cloud(handleOf<glide_session>(session), capacity, out, count);
      });
}

jint JNICALL trackedPoints(JNIEnv* env, jclass /*type*/, jlong session, jobject points) {
  return counted<glide_tracked_point>(
      env, points, [&](std::size_t capacity, glide_tracked_point* out, std::size_t* count) {
        return glide_session_tracked_points(handleOf<glide_session>(session), capacity, out, count);
      });
}

// NOLINTNEXTLINE(readability-function-size): Java has no structs to pass
jint JNICALL
hitTest(JNIEnv* env, jclass /*type*/, jlong session, jfloat x, jfloat y, jobject hits) {
  const std::array<float, 2> uv{x, y};
  return counted<glide_hit>(
      env, hits, [&](std::size_t capacity, glide_hit* out, std::size_t* count) {
        return glide_session_hit_test(
            handleOf<glide_session>(session), uv.data(), capacity, out, count);
      });
}

jlong JNICALL createAnchor(JNIEnv* env, jclass /*type*/, jlong session, jobject pose) {
  std::uint64_t anchor = 0;
  withStruct<glide_pose>(env, pose, [&](const glide_pose* given) {
    return glide_anchor_create(handleOf<glide_session>(session), given, &anchor);
  });
  return static_cast<jlong>(anchor);
}

void JNICALL anchor(JNIEnv* env, jclass /*type*/, jlong session, jlong id, jobject state) {
  withStruct<glide_anchor>(env, state, [&](glide_anchor* answer) {
    return glide_anchor_get(
        handleOf<glide_session>(session), static_cast<std::uint64_t>(id), answer);
  });
}

void JNICALL destroyAnchor(JNIEnv* env, jclass /*type*/, jlong session, jlong id) {
  guarded(env, [&] {
    return glide_anchor_destroy(handleOf<glide_session>(session), static_cast<std::uint64_t>(id));
  });
}

}  // namespace

std::vector<JNINativeMethod> sceneNatives() {
  return {
      native("setMetricScale", "(JF)V", setMetricScale),
      native("setGravity", "(JFFF)V", setGravity),
      native("setDisplay", "(JIII)V", setDisplay),
      native("viewMatrix", "(J[FI)V", viewMatrix),
      native("projectionMatrix", "(JFF[FI)V", projectionMatrix),
      native("pointCloud", "(JLjava/nio/ByteBuffer;)I", pointCloud),
      native("trackedPoints", "(JLjava/nio/ByteBuffer;)I", trackedPoints),
      native("hitTest", "(JFFLjava/nio/ByteBuffer;)I", hitTest),
      native("createAnchor", "(JLjava/nio/ByteBuffer;)J", createAnchor),
      native("anchor", "(JJLjava/nio/ByteBuffer;)V", anchor),
      native("destroyAnchor", "(JJ)V", destroyAnchor),
  };
}

}  // namespace glide_jni
