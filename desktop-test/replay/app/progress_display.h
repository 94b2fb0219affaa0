#pragma once

#include "replay/app/options.h"
#include "replay/outputs/run_record.h"

#include <chrono>
#include <string>

namespace glide::replay {

/// What one look at a running replay tells.
struct ProgressView {
  int done = 0;
  int total = 0;  ///< 0 when unknown
  int direct = 0, tracked = 0;
  double elapsed_s = 0.0;
  TrackingState state = TrackingState::initializing;
};

/// "[=====>    ] 120/320  45.2 fps  tracking  direct 83 %"
std::string progressBar(const ProgressView& view);
/// The same without the bar, for logs.
std::string progressLine(const ProgressView& view);

/// Progress on stderr: a bar that redraws itself on a terminal, a line every tenth of the way
/// otherwise, or nothing.
class ProgressDisplay {
 public:
  ProgressDisplay(Progress mode, int total);

  void show(const FrameRecord& frame);
  /// Ends the bar's line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool isLineDue() const;

  bool is_bar_ = false;
  bool is_silent_ = false;
  ProgressView view_;
  int last_line_ = 0;
  Clock::time_point start_, last_draw_;
};

}  // namespace glide::replay
