#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/render/playback.h"
#include "replay/render/split_view.h"
#include "replay/render/view_control.h"
#include "replay/render/viewer_window.h"

#include "glide/result.h"

#include <functional>
#include <memory>

namespace glide::replay {

/// What a live view needs. The window outlives it.
struct ViewerSetup {
  ViewerWindow& window;
  SplitViewSetup view;
  std::function<bool()> is_interrupted;  ///< Ctrl-C: it must not wait for a key then
};

/// --viewer: shows the split view of each frame in a window, and waits where a person says so. At
/// the end the window stays until it is closed.
class LiveViewer : public FrameObserver {
 public:
  static Result<std::unique_ptr<FrameObserver>> create(const ViewerSetup& setup);

  Status onFrame(const FrameMoment& moment) override;
  Status onEnd(const FinishedRun& finished) override;
  bool wantsToStop() const override { return playback_.hasQuit(); }

 private:
  LiveViewer(const ViewerSetup& setup, SplitView view);
  Status draw();
  void obey(const ViewerInput& input);

  ViewerWindow& window_;
  std::function<bool()> is_interrupted_;
  SplitView view_;
  ViewControl control_;
  Playback playback_;
};

}  // namespace glide::replay
