#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/outputs/point_colors.h"

namespace glide::replay {

/// Collects the colours of landmarks from the frames that show them.
class ColorWatcher : public FrameObserver {
 public:
  /// Fills `colors`, which outlives it.
  explicit ColorWatcher(PointColors& colors) : colors_(colors) {}

  Status onFrame(const FrameMoment& moment) override;
  Status onEnd(const FinishedRun&) override { return Unit{}; }

 private:
  PointColors& colors_;
};

}  // namespace glide::replay
