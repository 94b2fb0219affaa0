#pragma once

// The declaration of the NDK's android/hardware_buffer_jni.h that jni/hardware_buffer.h uses.

#include <android/hardware_buffer.h>
#include <jni.h>

#ifdef __cplusplus
extern "C" {
#endif

AHardwareBuffer* AHardwareBuffer_fromHardwareBuffer(JNIEnv* env, jobject buffer);

#ifdef __cplusplus
}
#endif
