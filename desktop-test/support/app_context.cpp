#include "support/app_context.h"

#include <EGL/egl.h>
#include <GLES3/gl31.h>
// Extension tokens and types need the core header first.
#include <GLES2/gl2ext.h>

#include <utility>

namespace glide::test {
namespace {

// NOLINTBEGIN(readability-function-size): the signature is KHR_debug's
void GL_APIENTRY
onMessage(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR_KHR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR_KHR) return;
  auto* complaints = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
  complaints->emplace_back(message);
}
// NOLINTEND(readability-function-size)

/// A configuration that renders to pbuffers, or the one of the current context.
EGLConfig chooseConfig(EGLDisplay display) {
  EGLConfig config = nullptr;
  EGLint count = 0;
  const EGLint with_surface[] = {
      EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  if (eglChooseConfig(display, with_surface, &config, 1, &count) == EGL_TRUE && count > 0) {
    return config;
  }
  EGLint id = 0;
  eglQueryContext(display, eglGetCurrentContext(), EGL_CONFIG_ID, &id);
  const EGLint same[] = {EGL_CONFIG_ID, id, EGL_NONE};
  eglChooseConfig(display, same, &config, 1, &count);
  return config;
}

EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext share) {
  const EGLint debug[] = {EGL_CONTEXT_MAJOR_VERSION,
                          3,
                          EGL_CONTEXT_MINOR_VERSION,
                          1,
                          EGL_CONTEXT_OPENGL_DEBUG,
                          EGL_TRUE,
                          EGL_NONE};
  const EGLint plain[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, share, debug);
  return context != EGL_NO_CONTEXT ? context : eglCreateContext(display, config, share, plain);
}

}  // namespace

Result<AppContext> AppContext::create(ContextSharing sharing) {
  AppContext app;
  app.display_ = eglGetCurrentDisplay();
  app.config_ = chooseConfig(app.display_);
  const EGLContext share =
      sharing == ContextSharing::current ? eglGetCurrentContext() : EGL_NO_CONTEXT;
  app.context_ = createContext(app.display_, app.config_, share);
  if (app.context_ == EGL_NO_CONTEXT) return Error{ErrorCode::unsupported, "no second context"};
  app.makeCurrent();
  app.listen();
  return app;
}

void AppContext::listen() {
  const auto set_callback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKKHRPROC>(
      eglGetProcAddress("glDebugMessageCallbackKHR"));
  if (set_callback == nullptr) return;
  set_callback(onMessage, complaints_.get());
  glEnable(GL_DEBUG_OUTPUT_KHR);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);
}

AppContext::AppContext(AppContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      config_(std::exchange(other.config_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      surface_(std::exchange(other.surface_, nullptr)),
      complaints_(std::move(other.complaints_)) {}

AppContext& AppContext::operator=(AppContext&& other) noexcept {
  std::swap(display_, other.display_);
  std::swap(config_, other.config_);
  std::swap(context_, other.context_);
  std::swap(surface_, other.surface_);
  std::swap(complaints_, other.complaints_);
  return *this;
}

AppContext::~AppContext() {
  if (context_ == nullptr) return;
  if (isCurrent()) makeNoContextCurrent();
  if (surface_ != nullptr) eglDestroySurface(display_, surface_);
  eglDestroyContext(display_, context_);
}

void AppContext::makeCurrent() const {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

bool AppContext::makeCurrentWithSurface() {
  const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 48, EGL_NONE};
  if (surface_ == nullptr) surface_ = eglCreatePbufferSurface(display_, config_, size);
  return surface_ != EGL_NO_SURFACE &&
         eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
}

bool AppContext::isCurrent() const { return eglGetCurrentContext() == context_; }

bool hasCurrentContext() { return eglGetCurrentContext() != EGL_NO_CONTEXT; }

void makeNoContextCurrent() {
  eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

ScopedCurrentContext::ScopedCurrentContext()
    : display_(eglGetCurrentDisplay()),
      draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)),
      context_(eglGetCurrentContext()) {}

void ScopedCurrentContext::restore() const { eglMakeCurrent(display_, draw_, read_, context_); }

}  // namespace glide::test
