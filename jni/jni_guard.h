#pragma once

#include "glide/glide.h"

#include <exception>
#include <jni.h>
#include <utility>

namespace glide_jni {

/// Looks up what raise() needs; false with a Java exception pending when it is not there. Called by
/// JNI_OnLoad. There is no JNI_OnUnload: the global reference that this makes holds the class, and
/// a VM unloads a library only after all its classes.
bool findClasses(JNIEnv* env);

/// Makes the Java exception of a status pending, unless there is one; returns the status.
glide_status raise(JNIEnv* env, glide_status status, const char* message);

/// raise() of GLIDE_ERROR_INVALID_ARGUMENT.
inline glide_status refuse(JNIEnv* env, const char* message) {
  return raise(env, GLIDE_ERROR_INVALID_ARGUMENT, message);
}

/// glide_last_error(), or the status' own text where that tells nothing.
const char* reasonOf(glide_status status);

/// Runs the body of a native method, a function of no arguments that returns a glide_status: an
/// error becomes its Java exception. No C++ exception gets out.
template <class Body>
void guarded(JNIEnv* env, Body&& body) noexcept {
  try {
    const glide_status status = std::forward<Body>(body)();
    if (status < 0) raise(env, status, reasonOf(status));
  } catch (const std::exception& e) {
    raise(env, GLIDE_ERROR_FATAL, e.what());
  }
}

}  // namespace glide_jni
