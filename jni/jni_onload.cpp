#include "jni_guard.h"
#include "natives.h"

#include <jni.h>

namespace {

constexpr jint kJniVersion = JNI_VERSION_1_6;
constexpr const char* kNative = "io/github/glideslam/Native";

bool registerNatives(JNIEnv* env) {
  const jclass native_class = env->FindClass(kNative);
  if (native_class == nullptr) return false;
  bool is_done = true;
  for (const auto& table : {glide_jni::sessionNatives(),
                            glide_jni::sceneNatives(),
                            glide_jni::mapNatives(),
                            glide_jni::layoutNatives()}) {
    const auto count = static_cast<jint>(table.size());
    is_done = is_done && env->RegisterNatives(native_class, table.data(), count) == JNI_OK;
  }
  env->DeleteLocalRef(native_class);
  return is_done;
}

JNIEnv* environmentOf(JavaVM* vm) {
  void* env = nullptr;
  return vm->GetEnv(&env, kJniVersion) == JNI_OK ? static_cast<JNIEnv*>(env) : nullptr;
}

}  // namespace

extern "C" JNIEXPORT jint JNICALL JNI_OnLoad(JavaVM* vm, void* /*reserved*/) {
  JNIEnv* const env = environmentOf(vm);
  if (env == nullptr) return JNI_ERR;
  return glide_jni::findClasses(env) && registerNatives(env) ? kJniVersion : JNI_ERR;
}
