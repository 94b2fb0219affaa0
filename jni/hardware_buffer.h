#pragma once

#include <jni.h>

#if defined(__ANDROID__)
#include <android/hardware_buffer_jni.h>
#endif

namespace glide_jni {

/// The AHardwareBuffer of an android.hardware.HardwareBuffer, borrowed from it. Null for null, and
/// where there are no such buffers.
inline void* nativeHardwareBuffer(JNIEnv* env, jobject buffer) {
#if defined(__ANDROID__)
  return buffer == nullptr ? nullptr : AHardwareBuffer_fromHardwareBuffer(env, buffer);
#else
  static_cast<void>(env);
  static_cast<void>(buffer);
  return nullptr;
#endif
}

}  // namespace glide_jni
