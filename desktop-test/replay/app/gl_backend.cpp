#include "replay/app/gl_backend.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#if defined(GLIDE_GLES)
#include "support/egl_context.h"
#endif

namespace glide::replay {
namespace {

/// The option that cannot do without a context; null when none is needed.
const char* needyOption(const GlDemand& demand) {
  if (demand.backend == Backend::gles) return "--backend gles";
  if (demand.input != InputKind::luma) return "--input";
  if (demand.renders) return "--render";
  return nullptr;
}

}  // namespace

#if defined(GLIDE_GLES)
struct GlBackend::Context {
  std::optional<test::EglContext> egl;
  std::optional<ViewerWindow> window;
};

namespace {

constexpr PictureSize kWindowSize{1280, 720};

/// Without a device node every GL is a software one, which automatic would refuse anyway; making it
/// only to find out costs a tenth of a second and the memory of a shader compiler.
bool hasGpuDevice() {
  std::error_code ignored;
  return std::filesystem::exists("/dev/dri", ignored) ||
         std::filesystem::exists("/dev/nvidia0", ignored);
}

Error missing(const std::string& option, const std::string& why) {
  return {ErrorCode::unsupported, option + ": " + why};
}

}  // namespace

Result<GlBackend> GlBackend::create(const GlDemand& demand) {
  GlBackend gl;
  gl.session_backend_ = demand.backend;
  const bool is_useful = demand.backend == Backend::automatic && hasGpuDevice();
  const bool serves_session =
      is_useful || demand.backend == Backend::gles || demand.input != InputKind::luma;
  if (!serves_session) gl.session_backend_ = Backend::cpu;
  if (demand.has_viewer) {
    Result<ViewerWindow> window = ViewerWindow::create(kWindowSize);
    if (!window) return missing("--viewer", window.error().message);
    gl.context_ = std::make_unique<Context>(Context{std::nullopt, std::move(*window)});
    return gl;
  }
  const char* needy = needyOption(demand);
  if (needy == nullptr && !is_useful) return gl;
  Result<test::EglContext> egl = test::EglContext::create(test::EglDebug::off);
  if (egl) {
    gl.context_ = std::make_unique<Context>(Context{std::move(*egl), std::nullopt});
  } else if (needy != nullptr) {
    return missing(needy, "no OpenGL ES 3.1 context can be made: " + egl.error().message);
  }
  return gl;
}

ViewerWindow* GlBackend::window() {
  return context_ && context_->window ? &*context_->window : nullptr;
}
#else
struct GlBackend::Context {};

Result<GlBackend> GlBackend::create(const GlDemand& demand) {
  const char* needy = demand.has_viewer ? "--viewer" : needyOption(demand);
  if (needy != nullptr) {
    return Error{ErrorCode::unsupported,
                 std::string(needy) + ": built without OpenGL ES (GLIDE_GLES)"};
  }
  GlBackend gl;
  gl.session_backend_ = demand.backend;
  return gl;
}

ViewerWindow* GlBackend::window() { return nullptr; }
#endif

GlBackend::GlBackend() = default;
GlBackend::GlBackend(GlBackend&&) noexcept = default;
GlBackend& GlBackend::operator=(GlBackend&&) noexcept = default;
GlBackend::~GlBackend() = default;

}  // namespace glide::replay
