#include "replay/app/gl_backend.h"

#include <filesystem>
#include <string>
#include <utility>

#if defined(GLIDE_GLES)
#include "support/egl_context.h"
#endif

namespace glide::replay {

#if defined(GLIDE_GLES)
struct GlBackend::Context {
  test::EglContext egl;
};

namespace {

/// Without a device node every GL is a software one, which automatic would refuse anyway; making it
/// only to find out costs a tenth of a second and the memory of a shader compiler.
bool hasGpuDevice() {
  std::error_code ignored;
  return std::filesystem::exists("/dev/dri", ignored) ||
         std::filesystem::exists("/dev/nvidia0", ignored);
}

}  // namespace

Result<GlBackend> GlBackend::create(Backend backend, InputKind input) {
  GlBackend gl;
  const bool is_needed = backend == Backend::gles || input != InputKind::luma;
  const bool is_useful = backend == Backend::automatic && hasGpuDevice();
  if (!is_needed && !is_useful) return gl;
  Result<test::EglContext> egl = test::EglContext::create(test::EglDebug::off);
  if (egl) {
    gl.context_ = std::make_unique<Context>(Context{std::move(egl).value()});
  } else if (is_needed) {
    const std::string asked = input == InputKind::luma ? "--backend gles" : "--input";
    return Error{ErrorCode::unsupported,
                 asked + ": no OpenGL ES 3.1 context can be made: " + egl.error().message};
  }
  return gl;
}
#else
struct GlBackend::Context {};

Result<GlBackend> GlBackend::create(Backend backend, InputKind input) {
  const char* asked = input == InputKind::luma ? "--backend gles" : "--input";
  if (backend == Backend::gles || input != InputKind::luma) {
    return Error{ErrorCode::unsupported,
                 std::string(asked) + ": built without OpenGL ES (GLIDE_GLES)"};
  }
  return GlBackend();
}
#endif

GlBackend::GlBackend() = default;
GlBackend::GlBackend(GlBackend&&) noexcept = default;
GlBackend& GlBackend::operator=(GlBackend&&) noexcept = default;
GlBackend::~GlBackend() = default;

}  // namespace glide::replay
