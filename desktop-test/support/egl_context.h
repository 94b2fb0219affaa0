#pragma once

#include "glide/result.h"

#include <string>

namespace glide::test {

/// Whether to ask for a debug context, which reports more through KHR_debug. Not every driver has
/// one.
enum class EglDebug { off, on };

/// An OpenGL ES 3.1 context without any window, current on the thread that made it until it is
/// destroyed there. Tries Mesa's surfaceless platform, ANGLE on SwiftShader, ANGLE on another
/// Vulkan device, EGL devices, then the default display; or only the platform that the environment
/// variable GLIDE_EGL_PLATFORM names.
class EglContext {
 public:
  /// unsupported, with what each platform said, when there is no such context.
  static Result<EglContext> create(EglDebug debug);

  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;
  ~EglContext();

  /// The platform that gave the context: "surfaceless", "angle-swiftshader",
  /// "angle-vulkan", "device" or "default".
  const std::string& platform() const { return platform_; }

  /// EGLDisplay and EGLContext, for tests that need more of EGL.
  void* display() const { return display_; }
  void* context() const { return context_; }

 private:
  EglContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::string platform_;
};

}  // namespace glide::test
