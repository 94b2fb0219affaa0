#include "replay/render/viewer_window.h"

#include <GLES3/gl31.h>
// GLFW must not include a desktop GL beside it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace glide::replay {
namespace {

constexpr int kSamples = 4;           // smooth lines; drivers without them give fewer
constexpr double kLongestWait = 0.1;  // s: how soon Ctrl-C is noticed

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::string lastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "unknown reason" : text;
}

std::optional<ViewerKey> keyOf(int key) {
  switch (key) {
    case GLFW_KEY_SPACE:
      return ViewerKey::pause;
    case GLFW_KEY_PERIOD:
      return ViewerKey::step;
    case GLFW_KEY_F:
      return ViewerKey::follow;
    case GLFW_KEY_Q:
    case GLFW_KEY_ESCAPE:
      return ViewerKey::quit;
    default:
      return std::nullopt;
  }
}

/// The library as long as a window may need it.
class GlfwLibrary {
 public:
  GlfwLibrary() : is_ready_(glfwInit() == GLFW_TRUE) {}
  ~GlfwLibrary() {
    if (is_ready_) glfwTerminate();
  }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
  bool isReady() const { return is_ready_; }

 private:
  bool is_ready_;
};

}  // namespace

class ViewerWindow::Impl {
 public:
  ~Impl() {
    if (window != nullptr) glfwDestroyWindow(window);
  }

  bool open(const PictureSize& size) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_SAMPLES, kSamples);
    window = glfwCreateWindow(size.width, size.height, "GLidE-SLAM", nullptr, nullptr);
    if (window == nullptr) return false;
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    listen();
    return true;
  }

  ViewerInput takeInput() {
    if (glfwWindowShouldClose(window) == GLFW_TRUE) input.keys.push_back(ViewerKey::quit);
    return std::exchange(input, {});
  }

  GlfwLibrary library;  // outlives the window
  GLFWwindow* window = nullptr;

 private:
  static Impl& of(GLFWwindow* window) {
    return *static_cast<Impl*>(glfwGetWindowUserPointer(window));
  }

  void listen() {
    glfwSetWindowUserPointer(window, this);
    glfwGetCursorPos(window, &cursor_x, &cursor_y);
    // NOLINTNEXTLINE(readability-function-size): the signature is GLFW's
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      const auto known = keyOf(key);
      if (known && action != GLFW_RELEASE) of(w).input.keys.push_back(*known);
    });
    glfwSetScrollCallback(
        window, [](GLFWwindow* w, double, double steps) { of(w).input.zoom_steps += steps; });
    glfwSetCursorPosCallback(window,
                             [](GLFWwindow* w, double x, double y) { of(w).moveCursor(x, y); });
  }

  void moveCursor(double x, double y) {
    const double x_px = x - std::exchange(cursor_x, x), y_px = y - std::exchange(cursor_y, y);
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS) return;
    input.drag_x_px += x_px;
    input.drag_y_px += y_px;
  }

  ViewerInput input;
  double cursor_x = 0.0, cursor_y = 0.0;
};

Result<ViewerWindow> ViewerWindow::create(const PictureSize& size) {
  if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY")) {
    return Error{ErrorCode::unsupported,
                 "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)"};
  }
  auto impl = std::make_unique<Impl>();
  if (!impl->library.isReady()) {
    return Error{ErrorCode::unsupported, "the display cannot be opened: " + lastError()};
  }
  if (!impl->open(size)) {
    return Error{ErrorCode::unsupported,
                 "no window with OpenGL ES 3.1 can be opened: " + lastError()};
  }
  return ViewerWindow(std::move(impl));
}

PictureSize ViewerWindow::size() const {
  PictureSize size;
  glfwGetFramebufferSize(impl_->window, &size.width, &size.height);
  return size;
}

void ViewerWindow::begin(const Color& background) {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(background[0], background[1], background[2], background[3]);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void ViewerWindow::present() { glfwSwapBuffers(impl_->window); }

ViewerInput ViewerWindow::poll() {
  glfwPollEvents();
  return impl_->takeInput();
}

ViewerInput ViewerWindow::wait() {
  glfwWaitEventsTimeout(kLongestWait);
  return impl_->takeInput();
}

ViewerWindow::ViewerWindow(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ViewerWindow::ViewerWindow(ViewerWindow&&) noexcept = default;
ViewerWindow& ViewerWindow::operator=(ViewerWindow&&) noexcept = default;
ViewerWindow::~ViewerWindow() = default;

}  // namespace glide::replay
