#include "jni_guard.h"

#include <cstring>

namespace glide_jni {
namespace {

constexpr const char* kException = "io/github/glideslam/GlideException";
constexpr const char* kFactory = "of";
constexpr const char* kFactoryType = "(I[B)Lio/github/glideslam/GlideException;";

// The one state of this library: written while it is loaded, read ever after.
jclass exception_class = nullptr;
jmethodID exception_of = nullptr;

}  // namespace

bool findClasses(JNIEnv* env) {
  const jclass found = env->FindClass(kException);
  if (found == nullptr) return false;
  exception_of = env->GetStaticMethodID(found, kFactory, kFactoryType);
  if (exception_of == nullptr) return false;
  exception_class = static_cast<jclass>(env->NewGlobalRef(found));
  env->DeleteLocalRef(found);
  return exception_class != nullptr;
}

const char* reasonOf(glide_status status) {
  const char* error = glide_last_error();
  return *error != '\0' ? error : glide_status_string(status);
}

glide_status raise(JNIEnv* env, glide_status status, const char* message) {
  if (env->ExceptionCheck() == JNI_TRUE) return status;
  // As bytes: JNI's strings are not UTF-8, and a message may have been cut within a character.
  const auto length = static_cast<jsize>(std::strlen(message));
  const jbyteArray utf8 = env->NewByteArray(length);
  if (utf8 == nullptr) return status;  // an OutOfMemoryError is pending
  env->SetByteArrayRegion(utf8, 0, length, reinterpret_cast<const jbyte*>(message));
  if (env->ExceptionCheck() == JNI_TRUE) return status;
  const jobject exception =
      env->CallStaticObjectMethod(exception_class, exception_of, static_cast<jint>(status), utf8);
  if (env->ExceptionCheck() == JNI_FALSE) env->Throw(static_cast<jthrowable>(exception));
  env->DeleteLocalRef(exception);
  env->DeleteLocalRef(utf8);
  return status;
}

}  // namespace glide_jni
