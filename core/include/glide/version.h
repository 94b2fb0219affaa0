#pragma once

/// Semantic version of the library. The C++ API may change until 1.0.
#define GLIDE_VERSION_MAJOR 0
#define GLIDE_VERSION_MINOR 1
#define GLIDE_VERSION_PATCH 0

/// Marks what the shared library exports; everything else is hidden.
#if defined(_WIN32)
#define GLIDE_API
#else
#define GLIDE_API __attribute__((visibility("default")))
#endif
