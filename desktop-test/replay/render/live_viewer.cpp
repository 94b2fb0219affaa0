#include "replay/render/live_viewer.h"

#include <optional>
#include <utility>

namespace glide::replay {

Result<std::unique_ptr<FrameObserver>> LiveViewer::create(const ViewerSetup& setup) {
  Result<SplitView> view = SplitView::create(setup.view);
  if (!view) return view.error();
  return std::unique_ptr<FrameObserver>(new LiveViewer(setup, std::move(*view)));
}

LiveViewer::LiveViewer(const ViewerSetup& setup, SplitView view)
    : window_(setup.window), is_interrupted_(setup.is_interrupted), view_(std::move(view)) {}

Status LiveViewer::onFrame(const FrameMoment& moment) {
  view_.show(moment);
  playback_.showFrame();
  Status drawn = draw();
  obey(window_.poll());
  while (drawn && !playback_.mayGoOn() && !is_interrupted_()) {
    drawn = draw();
    obey(window_.wait());
  }
  return drawn;
}

Status LiveViewer::onEnd(const FinishedRun& finished) {
  Status drawn = Unit{};
  if (finished.run.frames.empty()) return drawn;
  while (drawn && !playback_.hasQuit() && !is_interrupted_()) {  // no frame is left to go on to
    drawn = draw();
    obey(window_.wait());
  }
  return drawn;
}

Status LiveViewer::draw() {
  const PictureSize size = window_.size();
  if (size.width == 0 || size.height == 0) return Unit{};
  window_.begin(kPaperColor);
  Status drawn = view_.draw(size, control_);
  window_.present();
  return drawn;
}

void LiveViewer::obey(const ViewerInput& input) {
  control_.drag(input.drag_x_px, input.drag_y_px);
  control_.zoom(input.zoom_steps);
  for (const ViewerKey key : input.keys) {
    playback_.obey(key);
    const std::optional<Orbit> shown = view_.shownFrom(control_);
    if (key == ViewerKey::follow && shown) control_.toggleFollow(*shown);
  }
}

}  // namespace glide::replay
