#include "support/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace glide::test {
namespace {

struct Candidate {
  std::string platform;
  EGLDisplay display = EGL_NO_DISPLAY;
};

std::string hexError() {
  constexpr const char* kDigits = "0123456789abcdef";
  const auto error = static_cast<unsigned>(eglGetError());
  std::string text = "EGL error 0x";
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[(error >> shift) & 0xFU];
  return text;
}

std::vector<EGLDeviceEXT> eglDevices() {
  const auto query =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 8> devices{};
  EGLint count = 0;
  if (query == nullptr ||
      query(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) {
    return {};
  }
  return {devices.begin(), devices.begin() + count};
}

// EGL_ANGLE_platform_angle and its siblings; Mesa's eglext_angle.h lacks them.
constexpr EGLenum kPlatformAngle = 0x3202;
constexpr EGLint kAngleType = 0x3203, kAngleVulkan = 0x3450;
constexpr EGLint kAngleDevice = 0x3209, kAngleHardware = 0x320A, kAngleSwiftShader = 0x3487;
constexpr EGLint kAngleNativePlatform = 0x348F, kAngleHeadless = 0x34A6;

/// ANGLE, which new Androids put under OpenGL ES, on a Vulkan device of this type.
EGLDisplay angleDisplay(PFNEGLGETPLATFORMDISPLAYEXTPROC get, EGLint device_type) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (extensions == nullptr || std::strstr(extensions, "EGL_ANGLE_platform_angle") == nullptr) {
    return EGL_NO_DISPLAY;
  }
  const EGLint wanted[] = {kAngleType,
                           kAngleVulkan,
                           kAngleDevice,
                           device_type,
                           kAngleNativePlatform,
                           kAngleHeadless,
                           EGL_NONE};
  return get(kPlatformAngle, EGL_DEFAULT_DISPLAY, wanted);
}

/// What GLIDE_EGL_PLATFORM allows: one platform, or all when it is not set.
bool isAllowed(std::string_view platform) {
  const char* wanted = std::getenv("GLIDE_EGL_PLATFORM");
  return wanted == nullptr || *wanted == '\0' || platform == wanted;
}

std::vector<Candidate> candidates() {
  std::vector<Candidate> found;
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto add = [&](const char* platform, const auto& display) {
    if (isAllowed(platform)) found.push_back({platform, display()});
  };
  if (get != nullptr) {
    add("surfaceless",
        [&] { return get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr); });
    add("angle-swiftshader", [&] { return angleDisplay(get, kAngleSwiftShader); });
    add("angle-vulkan", [&] { return angleDisplay(get, kAngleHardware); });
    for (EGLDeviceEXT device : eglDevices()) {
      add("device", [&] { return get(EGL_PLATFORM_DEVICE_EXT, device, nullptr); });
    }
  }
  add("default", [] { return eglGetDisplay(EGL_DEFAULT_DISPLAY); });
  return found;
}

/// An OpenGL ES 3.1 context, or none. Softpipe has no debug contexts: it gives a plain one.
EGLContext createContext(EGLDisplay display, EGLConfig config, EglDebug debug) {
  std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1};
  std::vector<EGLint> wanted_debug = wanted;
  wanted.push_back(EGL_NONE);
  wanted_debug.insert(wanted_debug.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE});
  EGLContext context = EGL_NO_CONTEXT;
  if (debug == EglDebug::on) {
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted_debug.data());
  }
  if (context == EGL_NO_CONTEXT) {
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
  }
  return context;
}

/// Makes a context on `display` current and returns it; on failure says why in `problem`.
EGLContext makeCurrent(EGLDisplay display, EglDebug debug, std::string* problem) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglBindAPI(EGL_OPENGL_ES_API) == EGL_FALSE ||
      eglChooseConfig(display, wanted, &config, 1, &count) == EGL_FALSE || count == 0) {
    *problem = "no OpenGL ES 3 configuration";
    return EGL_NO_CONTEXT;
  }
  const EGLContext context = createContext(display, config, debug);
  if (context == EGL_NO_CONTEXT) {
    *problem = "no OpenGL ES 3.1 context, " + hexError();
    return EGL_NO_CONTEXT;
  }
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    *problem = "the context needs a surface, " + hexError();
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

}  // namespace

Result<EglContext> EglContext::create(EglDebug debug) {
  std::string problems;
  for (const Candidate& candidate : candidates()) {
    std::string problem;
    if (candidate.display == EGL_NO_DISPLAY ||
        eglInitialize(candidate.display, nullptr, nullptr) == EGL_FALSE) {
      problem = "no display, " + hexError();
    } else if (const EGLContext context = makeCurrent(candidate.display, debug, &problem);
               context != EGL_NO_CONTEXT) {
      EglContext made;
      made.display_ = candidate.display;
      made.context_ = context;
      made.platform_ = candidate.platform;
      return made;
    }
    problems += (problems.empty() ? "" : "; ") + candidate.platform + ": " + problem;
  }
  if (problems.empty()) problems = "GLIDE_EGL_PLATFORM names no platform of this EGL";
  return Error{ErrorCode::unsupported, "no OpenGL ES 3.1 context (" + problems + ")"};
}

EglContext::EglContext(EglContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      platform_(std::move(other.platform_)) {}

EglContext& EglContext::operator=(EglContext&& other) noexcept {
  std::swap(display_, other.display_);
  std::swap(context_, other.context_);
  std::swap(platform_, other.platform_);
  return *this;
}

EglContext::~EglContext() {
  if (context_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  // The display is shared by the process: terminating it would end other contexts on it.
}

}  // namespace glide::test
