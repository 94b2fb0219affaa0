#pragma once

#include "jni_guard.h"

#include <cstddef>
#include <cstdint>

namespace glide_jni {

/// The C handle behind a Java long; the C functions recognise the stale ones.
template <class Handle>
Handle* handleOf(jlong number) {
  return reinterpret_cast<Handle*>(
      static_cast<std::intptr_t>(number));  // NOLINT(performance-no-int-to-ptr)
}

inline jlong numberOf(const void* handle) {
  return static_cast<jlong>(reinterpret_cast<std::intptr_t>(handle));
}

/// The memory of a direct buffer.
struct DirectBytes {
  std::uint8_t* data = nullptr;
  std::int64_t size = 0;
};

/// Nothing with an InvalidArgumentException pending when the buffer is null or not direct.
inline DirectBytes bytesOf(JNIEnv* env, jobject buffer) {
  void* const data = buffer == nullptr ? nullptr : env->GetDirectBufferAddress(buffer);
  if (data == nullptr) {
    refuse(env, "a buffer is null or not direct");
    return {};
  }
  return {static_cast<std::uint8_t*>(data), env->GetDirectBufferCapacity(buffer)};
}

/// The struct in a direct buffer; null with an InvalidArgumentException pending when there is none,
/// or it does not fit.
template <class T>
T* structOf(JNIEnv* env, jobject buffer) {
  const DirectBytes bytes = bytesOf(env, buffer);
  if (bytes.data == nullptr) return nullptr;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(bytes.data) % alignof(T) == 0;
  if (is_aligned && bytes.size >= static_cast<std::int64_t>(sizeof(T)))
    return reinterpret_cast<T*>(bytes.data);
  refuse(env, "a buffer is too small for its struct, or not aligned");
  return nullptr;
}

/// As many structs as fit into a direct buffer; none for null.
template <class T>
struct Structs {
  T* data = nullptr;
  std::size_t capacity = 0;
};

/// With an InvalidArgumentException pending unless the buffer is null or a direct one.
template <class T>
Structs<T> structsOf(JNIEnv* env, jobject buffer) {
  if (buffer == nullptr) return {};
  const DirectBytes bytes = bytesOf(env, buffer);
  return {reinterpret_cast<T*>(bytes.data), static_cast<std::size_t>(bytes.size) / sizeof(T)};
}

/// The two-call idiom: runs call(capacity, T*, count*) on as many structs as fit into the buffer
/// (none for null), and returns the count; more than an int holds never fits into memory.
template <class T, class Call>
jint counted(JNIEnv* env, jobject buffer, Call&& call) {
  std::size_t count = 0;
  guarded(env, [&] {
    const auto out = structsOf<T>(env, buffer);
    return call(out.capacity, out.data, &count);
  });
  return static_cast<jint>(count);
}

/// Runs call(T*) on the struct in a direct buffer.
template <class T, class Call>
void withStruct(JNIEnv* env, jobject buffer, Call&& call) {
  guarded(env, [&]() -> glide_status {
    T* const given = structOf<T>(env, buffer);
    return given == nullptr ? GLIDE_ERROR_INVALID_ARGUMENT : call(given);
  });
}

}  // namespace glide_jni
