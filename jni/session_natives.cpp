// The life of a session, its frames and what it is told.
#include "arguments.h"
#include "hardware_buffer.h"
#include "jni_guard.h"
#include "natives.h"

#include "glide/glide.h"

#include <vector>

namespace glide_jni {
namespace {

using SessionCall = glide_status (*)(glide_session*);

/// Native methods of a session and nothing else.
template <SessionCall call>
void JNICALL simple(JNIEnv* env, jclass /*type*/, jlong session) {
  guarded(env, [&] { return call(handleOf<glide_session>(session)); });
}

/// Points into `texts`, zero-ended texts in a row.
std::vector<const char*> splitTexts(const std::vector<char>& texts) {
  std::vector<const char*> result;
  bool is_begin = true;
  for (const char& character : texts) {
    if (is_begin) result.push_back(&character);
    is_begin = character == '\0';
  }
  return result;
}

glide_status createSession(JNIEnv* env, glide_config config, jbyteArray given, jlong* out) {
  if (given == nullptr) return refuse(env, "settings is null");
  std::vector<char> texts(static_cast<std::size_t>(env->GetArrayLength(given)));
  env->GetByteArrayRegion(
      given, 0, static_cast<jsize>(texts.size()), reinterpret_cast<jbyte*>(texts.data()));
  texts.push_back('\0');  // whatever came, the last text ends
  std::vector<const char*> settings = splitTexts(texts);
  settings.pop_back();  // that zero alone is no text
  config.setting_count = static_cast<uint32_t>(settings.size());
  config.settings = settings.empty() ? nullptr : settings.data();
  glide_session* session = nullptr;
  const glide_status status = glide_session_create(&config, &session);
  *out = numberOf(session);
  return status;
}

jlong JNICALL create(JNIEnv* env, jclass /*type*/, jobject config, jbyteArray settings) {
  jlong session = 0;
  withStruct<glide_config>(env, config, [&](const glide_config* given) {
    return createSession(env, *given, settings, &session);
  });
  return session;
}

void JNICALL destroy(JNIEnv* /*env*/, jclass /*type*/, jlong session) {
  glide_session_destroy(handleOf<glide_session>(session));
}

/// Whether the image lies within its buffer; its `pixels` is the place of the first one there.
bool isWithin(const glide_image& image, std::int64_t first, std::int64_t size) {
  if (image.width <= 0 || image.height <= 0 || image.row_stride < image.width) return false;
  const std::int64_t left = size - image.width;
  if (first < 0 || first > left) return false;
  return (left - first) / image.row_stride >= image.height - 1;
}

glide_status setPixels(JNIEnv* env, jobject pixels, glide_image* image) {
  const DirectBytes bytes = bytesOf(env, pixels);
  if (bytes.data == nullptr) return GLIDE_ERROR_INVALID_ARGUMENT;
  const jlong first = numberOf(image->pixels);
  if (!isWithin(*image, first, bytes.size))
    return refuse(env, "the image is not within its buffer");
  image->pixels = bytes.data + first;
  return GLIDE_OK;
}

glide_status setContent(JNIEnv* env, jobject pixels, jobject hardware_buffer, glide_image* image) {
  if (image->kind == GLIDE_IMAGE_LUMA8) return setPixels(env, pixels, image);
  image->pixels = nullptr;
  if (image->kind != GLIDE_IMAGE_HARDWARE_BUFFER) return GLIDE_OK;
  image->hardware_buffer = nativeHardwareBuffer(env, hardware_buffer);
  if (image->hardware_buffer != nullptr) return GLIDE_OK;
  return raise(env, GLIDE_ERROR_UNSUPPORTED_CONFIGURATION, "there are no hardware buffers here");
}

// NOLINTNEXTLINE(readability-function-size): one call per frame carries all of it
void JNICALL update(JNIEnv* env,
                    jclass /*type*/,
                    jlong session,
                    jobject image,
                    jobject pixels,
                    jobject hardware_buffer,
                    jobject frame) {
  guarded(env, [&]() -> glide_status {
    const auto* given = structOf<glide_image>(env, image);
    if (given == nullptr) return GLIDE_ERROR_INVALID_ARGUMENT;
    auto* answer = structOf<glide_frame>(env, frame);
    if (answer == nullptr) return GLIDE_ERROR_INVALID_ARGUMENT;
    glide_image input = *given;
    const glide_status status = setContent(env, pixels, hardware_buffer, &input);
    if (status != GLIDE_OK) return status;
    return glide_session_update(handleOf<glide_session>(session), &input, answer);
  });
}

void JNICALL backend(JNIEnv* env, jclass /*type*/, jlong session, jobject info) {
  withStruct<glide_backend_info>(env, info, [&](glide_backend_info* answer) {
    return glide_session_backend(handleOf<glide_session>(session), answer);
  });
}

void JNICALL pushImu(JNIEnv* env, jclass /*type*/, jlong session, jobject samples) {
  guarded(env, [&]() -> glide_status {
    const auto given = structsOf<glide_imu_sample>(env, samples);
    if (given.data == nullptr) return refuse(env, "samples is null or not direct");
    return glide_session_push_imu(handleOf<glide_session>(session), given.data, given.capacity);
  });
}

void JNICALL locate(JNIEnv* env, jclass /*type*/, jlong session, jlong t_ns, jobject location) {
  withStruct<glide_location>(env, location, [&](glide_location* answer) {
    return glide_session_locate(handleOf<glide_session>(session), t_ns, answer);
  });
}

}  // namespace

std::vector<JNINativeMethod> sessionNatives() {
  return {
      native("create", "(Ljava/nio/ByteBuffer;[B)J", create),
      native("destroy", "(J)V", destroy),
      native("pause", "(J)V", simple<glide_session_pause>),
      native("resume", "(J)V", simple<glide_session_resume>),
      native("reset", "(J)V", simple<glide_session_reset>),
      native("waitForMapping", "(J)V", simple<glide_session_wait_for_mapping>),
      native("releaseGl", "(J)V", simple<glide_session_release_gl>),
      native("abandonGl", "(J)V", simple<glide_session_abandon_gl>),
      native(
          "update",
          "(JLjava/nio/ByteBuffer;Ljava/nio/ByteBuffer;Ljava/lang/Object;Ljava/nio/ByteBuffer;)V",
          update),
      native("backend", "(JLjava/nio/ByteBuffer;)V", backend),
      native("pushImu", "(JLjava/nio/ByteBuffer;)V", pushImu),
      native("locate", "(JJLjava/nio/ByteBuffer;)V", locate),
  };
}

}  // namespace glide_jni
