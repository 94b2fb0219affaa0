#include "replay/render/video_recorder.h"

#include "base/stopwatch.h"

#include <fmt/format.h>

#include <utility>

namespace glide::replay {
Result<std::unique_ptr<FrameObserver>> VideoRecorder::create(const RecorderSetup& setup) {
  Result<SplitView> view = SplitView::create(setup.view);
  if (!view) return view.error();
  const CameraIntrinsics& camera = setup.view.camera;
  const PictureSize size = videoSize(setup.view.view, {camera.width, camera.height});
  Result<RenderTarget> target = RenderTarget::create(size.width, size.height);
  if (!target) return target.error();
  Result<std::unique_ptr<FrameSink>> sink = openFrameSink(setup.path, size);
  if (!sink) return sink.error();
  return std::unique_ptr<FrameObserver>(
      new VideoRecorder(setup, std::move(*view), std::move(*target), std::move(*sink)));
}

VideoRecorder::VideoRecorder(const RecorderSetup& setup,
                             SplitView view,
                             RenderTarget target,
                             std::unique_ptr<FrameSink> sink)
    : path_(setup.path),
      tell_(setup.tell),
      view_(std::move(view)),
      target_(std::move(target)),
      sink_(std::move(sink)) {}

Status VideoRecorder::onFrame(const FrameMoment& moment) {
  Stopwatch watch;
  view_.show(moment);
  const PictureSize size{target_.width(), target_.height()};
  Status begun = target_.begin(kPaperColor);
  if (!begun) return begun;
  Status drawn = view_.draw(size, ViewControl());
  if (!drawn) return drawn;
  const RgbPicture picture{size.width, size.height, target_.readRgb()};
  if (picture.rgb.empty()) return Error{ErrorCode::gl, "the picture cannot be read back"};
  drawn_ms_ += watch.lapMs();
  Status written = sink_->write(picture, moment.record.result.t_ns);
  written_ms_ += watch.lapMs();
  return written;
}

Status VideoRecorder::onEnd(const FinishedRun& finished) {
  Status whole = sink_->finish();
  if (!whole) return whole;
  const std::size_t frames = finished.run.frames.size();
  if (frames == 0) return Unit{};
  tell_(fmt::format("{}: {} frames (drawing {:.1f} ms, encoding {:.1f} ms per frame)",
                    path_.string(),
                    frames,
                    drawn_ms_ / static_cast<double>(frames),
                    written_ms_ / static_cast<double>(frames)));
  return Unit{};
}

}  // namespace glide::replay
