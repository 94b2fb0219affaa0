#include "replay/render/viewer_window.h"

namespace glide::replay {

class ViewerWindow::Impl {};

Result<ViewerWindow> ViewerWindow::create(const PictureSize&) {
  return Error{ErrorCode::unsupported,
               "this build has no windows: GLFW was not there (apt-get install libglfw3-dev, then "
               "build again)"};
}

PictureSize ViewerWindow::size() const { return {}; }
void ViewerWindow::begin(const Color&) {}
void ViewerWindow::present() {}
ViewerInput ViewerWindow::poll() { return {}; }
ViewerInput ViewerWindow::wait() { return {}; }

ViewerWindow::ViewerWindow(ViewerWindow&&) noexcept = default;
ViewerWindow& ViewerWindow::operator=(ViewerWindow&&) noexcept = default;
ViewerWindow::~ViewerWindow() = default;

}  // namespace glide::replay
