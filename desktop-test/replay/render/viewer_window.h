#pragma once

#include "replay/render/playback.h"
#include "replay/render/split_layout.h"

#include "glide/render_types.h"
#include "glide/result.h"

#include <memory>
#include <vector>

namespace glide::replay {

/// What a person did since the last time one looked.
struct ViewerInput {
  std::vector<ViewerKey> keys;              ///< closing the window is quit
  double drag_x_px = 0.0, drag_y_px = 0.0;  ///< with the left button down; right, down
  double zoom_steps = 0.0;                  ///< of the wheel; away from the person: nearer
};

/// A window with an OpenGL ES 3.1 context, current on the thread that made it until it is destroyed
/// there. All calls on that thread. At most one at a time.
class ViewerWindow {
 public:
  /// unsupported, with the reason: no display, no such context, or a build without windows.
  static Result<ViewerWindow> create(const PictureSize& size);

  ViewerWindow(ViewerWindow&&) noexcept;
  ViewerWindow& operator=(ViewerWindow&&) noexcept;
  ~ViewerWindow();

  /// Of its framebuffer, px; a side is 0 while it is minimised.
  PictureSize size() const;
  /// Binds its framebuffer and clears it.
  void begin(const Color& background);
  /// Shows what was drawn.
  void present();
  /// What has happened so far; or waits for something to happen, a fraction of a second at most.
  ViewerInput poll();
  ViewerInput wait();

 private:
  class Impl;
  explicit ViewerWindow(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide::replay
