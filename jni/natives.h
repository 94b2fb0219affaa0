#pragma once

#include <jni.h>
#include <vector>

namespace glide_jni {

/// The functions of io.github.glideslam.Native, by the part of glide.h that they call.
std::vector<JNINativeMethod> sessionNatives();
std::vector<JNINativeMethod> sceneNatives();
std::vector<JNINativeMethod> mapNatives();
std::vector<JNINativeMethod> layoutNatives();

/// An entry of these tables. The JDK's JNINativeMethod lacks the const that Android's has.
template <class Function>
JNINativeMethod native(const char* name, const char* type, Function* function) {
  return {const_cast<char*>(name), const_cast<char*>(type), reinterpret_cast<void*>(function)};
}

}  // namespace glide_jni
