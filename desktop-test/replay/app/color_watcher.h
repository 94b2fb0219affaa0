#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/outputs/point_colors.h"

#include <cstdint>
#include <optional>

namespace glide::replay {

/// Collects the colours of landmarks from the frames that show them: those that the indirect
/// tracker matched, and those that a keyframe has added to the map.
class ColorWatcher : public FrameObserver {
 public:
  /// For frames of the camera. Fills `colors`, which outlives it.
  ColorWatcher(const CameraIntrinsics& camera, PointColors& colors)
      : camera_(camera), colors_(colors) {}

  Status onFrame(const FrameMoment& moment) override;
  Status onEnd(const FinishedRun&) override { return Unit{}; }

 private:
  void addNewLandmarks(const FrameMoment& moment);

  CameraIntrinsics camera_;
  PointColors& colors_;
  std::optional<std::uint64_t> map_generation_;  ///< of the frame before
  std::uint64_t next_landmark_ = 0;              ///< ids below were in the map already
};

}  // namespace glide::replay
