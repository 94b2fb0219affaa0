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
  takes_step_ = false;
  return drawAndWait();
}

Status LiveViewer::onEnd(const FinishedRun& finished) {
  if (finished.run.frames.empty() || is_interrupted_()) return Unit{};
  is_paused_ = true;
  takes_step_ = false;
  Status drawn = Unit{};
  while (drawn && !has_quit_) {  // there is no frame to go on to
    drawn = drawAndWait();
    is_paused_ = true;
    takes_step_ = false;
  }
  return drawn;
}

Status LiveViewer::drawAndWait() {
  Status drawn = draw();
  obey(window_.poll());
  while (drawn && is_paused_ && !takes_step_ && !has_quit_ && !is_interrupted_()) {
    drawn = draw();
    obey(window_.wait());
  }
  return drawn;
}

Status LiveViewer::draw() {
  const PictureSize size = window_.size();
  if (size.width == 0 || size.height == 0) return Unit{};
  window_.begin(kPaperColor);
  const Status drawn = view_.draw(size, control_);
  window_.present();
  return drawn;
}

void LiveViewer::obey(const ViewerInput& input) {
  control_.drag(input.drag_x_px, input.drag_y_px);
  control_.zoom(input.zoom_steps);
  for (const ViewerKey key : input.keys) {
    switch (key) {
      case ViewerKey::pause:
        is_paused_ = !is_paused_;
        break;
      case ViewerKey::step:
        is_paused_ = takes_step_ = true;
        break;
      case ViewerKey::follow:
        if (const auto shown = view_.shownFrom(window_.size(), control_)) {
          control_.toggleFollow(*shown);
        }
        break;
      case ViewerKey::quit:
        has_quit_ = true;
        break;
    }
  }
}

}  // namespace glide::replay
