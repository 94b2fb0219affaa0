#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/render/frame_sink.h"
#include "replay/render/split_view.h"

#include "glide/render_target.h"
#include "glide/result.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace glide::replay {

/// What the recorder of a replay needs.
struct RecorderSetup {
  std::filesystem::path path;  ///< video or folder
  SplitViewSetup view;
  std::function<void(const std::string&)> tell;  ///< where it says what it has written
};

/// --render: draws every frame's view into a video or a folder of pictures.
class VideoRecorder : public FrameObserver {
 public:
  /// io when the path cannot be written, unsupported when the context cannot draw.
  static Result<std::unique_ptr<FrameObserver>> create(const RecorderSetup& setup);

  Status onFrame(const FrameMoment& moment) override;
  Status onEnd(const FinishedRun& finished) override;

 private:
  VideoRecorder(const RecorderSetup& setup,
                SplitView view,
                RenderTarget target,
                std::unique_ptr<FrameSink> sink);

  std::filesystem::path path_;
  std::function<void(const std::string&)> tell_;
  SplitView view_;
  RenderTarget target_;
  std::unique_ptr<FrameSink> sink_;
  double drawn_ms_ = 0.0, written_ms_ = 0.0;  ///< in total
};

}  // namespace glide::replay
