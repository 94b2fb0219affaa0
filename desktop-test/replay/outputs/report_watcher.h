#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/outputs/report_thumbnails.h"

#include <cstddef>

namespace glide::replay {

/// Bytes that the pictures take of a report, so that one of 600 frames stays under 2 MB.
inline constexpr std::size_t kPictureBudget = 700'000;

/// Collects pictures while a replay runs and writes report.html at its end.
class ReportWatcher : public FrameObserver {
 public:
  Status onFrame(const FrameMoment& moment) override;
  Status onEnd(const FinishedRun& finished) override;

 private:
  ThumbnailStrip strip_{kPictureBudget};
};

}  // namespace glide::replay
