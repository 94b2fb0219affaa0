#pragma once

// Declarations of the NDK's media/NdkImage.h, as far as docs/android.md uses it.

#include <stdint.h>

typedef struct AImage AImage;
typedef int media_status_t;

media_status_t AImage_getTimestamp(const AImage* image, int64_t* timestamp_ns);
media_status_t AImage_getWidth(const AImage* image, int32_t* width);
media_status_t AImage_getHeight(const AImage* image, int32_t* height);
media_status_t AImage_getPlaneData(const AImage* image, int plane, uint8_t** data, int* size);
media_status_t AImage_getPlaneRowStride(const AImage* image, int plane, int32_t* row_stride);
