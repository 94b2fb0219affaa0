#include "replay/app/progress_display.h"

#include "glide/enum_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace glide::replay {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kRedraw{100};  // ten times a second is smooth and cheap
constexpr int kPlainLines = 10;                    // per run
constexpr int kPlainInterval = 300;                // frames, when the total is unknown

}  // namespace

std::string progressLine(const ProgressView& view) {
  const double fps = view.elapsed_s > 0.0 ? view.done / view.elapsed_s : 0.0;
  const std::string total = view.total > 0 ? fmt::format("/{}", view.total) : "";
  const std::string share =
      view.tracked > 0 ? fmt::format("direct {:.0f} %", 100.0 * view.direct / view.tracked) : "";
  return fmt::format(
      "{}{} frames  {:.1f} fps  {:<12} {}", view.done, total, fps, enumName(view.state), share);
}

std::string progressBar(const ProgressView& view) {
  if (view.total <= 0) return progressLine(view);
  const double share = std::min(1.0, static_cast<double>(view.done) / view.total);
  const int filled = static_cast<int>(share * kBarWidth);
  std::string bar(static_cast<std::size_t>(filled), '=');
  if (filled < kBarWidth) bar += '>';
  bar.resize(kBarWidth, ' ');
  return "[" + bar + "] " + progressLine(view);
}

ProgressDisplay::ProgressDisplay(Progress mode, int total) : start_(Clock::now()) {
  is_silent_ = mode == Progress::none;
  is_bar_ = mode == Progress::automatic && isatty(STDERR_FILENO) != 0;
  view_.total = total;
}

void ProgressDisplay::show(const FrameRecord& frame) {
  if (is_silent_) return;
  view_.done = frame.index + 1;
  view_.state = frame.result.state;
  view_.tracked += frame.result.state == TrackingState::tracking;
  view_.direct += frame.result.tracker == TrackerKind::direct;
  const Clock::time_point now = Clock::now();
  view_.elapsed_s = std::chrono::duration<double>(now - start_).count();
  if (is_bar_ && (now - last_draw_ >= kRedraw || view_.done == view_.total)) {
    last_draw_ = now;
    std::cerr << "\r" << progressBar(view_) << "\x1b[K" << std::flush;
  } else if (!is_bar_ && isLineDue()) {
    last_line_ = view_.done;
    std::cerr << progressLine(view_) << std::endl;
  }
}

bool ProgressDisplay::isLineDue() const {
  if (view_.total <= 0) return view_.done - last_line_ >= kPlainInterval;
  return view_.done * kPlainLines / view_.total > last_line_ * kPlainLines / view_.total;
}

void ProgressDisplay::finish() {
  if (is_bar_ && view_.done > 0) std::cerr << "\r" << progressBar(view_) << "\x1b[K" << std::endl;
}

}  // namespace glide::replay
