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

Result<GlBackend> GlBackend::create(Backend backend) {
  GlBackend gl;
  if (backend == Backend::cpu) return gl;
  if (backend == Backend::automatic && !hasGpuDevice()) return gl;
  Result<test::EglContext> egl = test::EglContext::create(test::EglDebug::off);
  if (egl) {
    gl.context_ = std::make_unique<Context>(Context{std::move(egl).value()});
  } else if (backend == Backend::gles) {
    return Error{ErrorCode::unsupported,
                 "--backend gles: no OpenGL ES 3.1 context can be made: " + egl.error().message};
  }
  return gl;
}
#else
struct GlBackend::Context {};

Result<GlBackend> GlBackend::create(Backend backend) {
  if (backend == Backend::gles) {
    return Error{ErrorCode::unsupported, "--backend gles: built without OpenGL ES (GLIDE_GLES)"};
  }
  return GlBackend();
}
#endif

GlBackend::GlBackend() = default;
GlBackend::GlBackend(GlBackend&&) noexcept = default;
GlBackend& GlBackend::operator=(GlBackend&&) noexcept = default;
GlBackend::~GlBackend() = default;

}  // namespace glide::replay
