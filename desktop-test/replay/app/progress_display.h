#pragma once

#include "replay/app/options.h"
#include "replay/common/terminal.h"
#include "replay/outputs/run_record.h"

#include "glide/session.h"

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
  TrackerKind tracker = TrackerKind::none;
  MapSize map;
};

/// Room and colours for a line.
struct ProgressLook {
  int columns = 80;
  bool has_color = false;
};

/// "[=====>    ] 120/320  45.2 fps  tracking direct  12 keyframes  3456 landmarks  direct 83 %".
/// Always shorter than look.columns: says less where there is less room. Without the bar when the
/// total is unknown.
std::string progressBar(const ProgressView& view, const ProgressLook& look);
/// Everything but the bar, for logs; as long as it is.
std::string progressLine(const ProgressView& view, bool has_color);

/// Progress on stderr: a bar that redraws itself on a terminal, a line every tenth of the way
/// otherwise, or nothing.
class ProgressDisplay {
 public:
  ProgressDisplay(Progress mode, int total);
  /// Ends the bar's line.
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const FrameRecord& frame, const Session& session);

 private:
  using Clock = std::chrono::steady_clock;

  bool isLineDue() const;
  void drawBar() const;

  bool is_bar_ = false;
  bool is_silent_ = false;
  bool has_color_ = false;
  ProgressView view_;
  int last_line_ = 0;
  Clock::time_point start_, last_draw_;
};

}  // namespace glide::replay
