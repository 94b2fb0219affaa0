#include "replay/app/progress_display.h"

#include "glide/enum_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace glide::replay {
namespace {

constexpr int kLongestBar = 30, kShortestBar = 8;  // characters between the brackets
constexpr std::size_t kStateWidth = 17;  // "tracking indirect": what stands right of it keeps still
constexpr std::chrono::milliseconds kRedraw{100};  // ten times a second is smooth and cheap
constexpr int kPlainLines = 10;                    // per run
constexpr int kPlainInterval = 300;                // frames, when the total is unknown

/// How much is said, from everything to the least.
enum class Detail { full, without_share, short_names, without_map, count_only };

void addState(const ProgressView& view, InkedText* line) {
  const std::size_t begin = line->width();
  line->add("  ", Ink::plain);
  line->add(enumName(view.state), view.state == TrackingState::lost ? Ink::alarm : Ink::plain);
  if (view.state == TrackingState::tracking) {
    line->add(" ", Ink::plain);
    line->add(enumName(view.tracker),
              view.tracker == TrackerKind::direct ? Ink::direct : Ink::indirect);
  }
  const std::size_t end = begin + 2 + kStateWidth;
  if (line->width() < end) line->add(std::string(end - line->width(), ' '), Ink::plain);
}

void addMap(const MapSize& map, Detail detail, InkedText* line) {
  const bool is_short = detail >= Detail::short_names;
  line->add(fmt::format("  {} {}  {} {}",
                        map.keyframes,
                        is_short ? "kf" : "keyframes",
                        map.landmarks,
                        is_short ? "lm" : "landmarks"),
            Ink::plain);
}

InkedText textOf(const ProgressView& view, Detail detail, bool has_color) {
  InkedText line(has_color);
  const double fps = view.elapsed_s > 0.0 ? view.done / view.elapsed_s : 0.0;
  const std::string total = view.total > 0 ? fmt::format("/{}", view.total) : "";
  line.add(fmt::format("{}{}", view.done, total), Ink::plain);
  if (detail == Detail::count_only) return line;
  line.add(fmt::format("  {:5.1f} fps", fps), Ink::plain);
  addState(view, &line);
  if (detail < Detail::without_map) addMap(view.map, detail, &line);
  if (detail == Detail::full && view.tracked > 0)
    line.add(fmt::format("  direct {:.0f} %", 100.0 * view.direct / view.tracked), Ink::plain);
  return line;
}

/// "[=====>    ] " of this many characters between the brackets.
std::string barOf(const ProgressView& view, int length) {
  const double share = std::min(1.0, static_cast<double>(view.done) / view.total);
  const auto filled = static_cast<std::size_t>(share * length);
  std::string bar(filled, '=');
  if (filled < static_cast<std::size_t>(length)) bar += '>';
  bar.resize(static_cast<std::size_t>(length), ' ');
  return "[" + bar + "] ";
}

constexpr int kBrackets = 3;  // with the space behind

}  // namespace

std::string progressLine(const ProgressView& view, bool has_color) {
  return textOf(view, Detail::full, has_color).text();
}

std::string progressBar(const ProgressView& view, const ProgressLook& look) {
  const int room = look.columns - 1;  // a full line would make some terminals wrap
  const int least_bar = view.total > 0 ? kShortestBar + kBrackets : 0;
  for (const Detail detail : {Detail::full,
                              Detail::without_share,
                              Detail::short_names,
                              Detail::without_map,
                              Detail::count_only}) {
    const InkedText line = textOf(view, detail, look.has_color);
    const int rest = room - static_cast<int>(line.width());
    if (rest < least_bar) continue;
    if (view.total <= 0) return line.text();
    return barOf(view, std::min(rest - kBrackets, kLongestBar)) + line.text();
  }
  const InkedText count = textOf(view, Detail::count_only, look.has_color);
  return static_cast<int>(count.width()) <= room ? count.text() : "";
}

ProgressDisplay::ProgressDisplay(Progress mode, int total) : start_(Clock::now()) {
  const Terminal terminal = terminalOf(STDERR_FILENO);
  is_silent_ = mode == Progress::none;
  is_bar_ = mode == Progress::automatic && terminal.can_redraw;
  has_color_ = terminal.has_color;
  view_.total = total;
}

ProgressDisplay::~ProgressDisplay() {
  if (!is_bar_ || view_.done == 0) return;
  drawBar();
  std::cerr << std::endl;
}

void ProgressDisplay::show(const FrameRecord& frame, const Session& session) {
  if (is_silent_) return;
  view_.done = frame.index + 1;
  view_.state = frame.result.state;
  view_.tracker = frame.result.tracker;
  view_.tracked += frame.result.state == TrackingState::tracking;
  view_.direct += frame.result.tracker == TrackerKind::direct;
  const Clock::time_point now = Clock::now();
  view_.elapsed_s = std::chrono::duration<double>(now - start_).count();
  view_.map = session.mapSize();
  if (is_bar_ && now - last_draw_ >= kRedraw) {
    last_draw_ = now;
    drawBar();
  } else if (!is_bar_ && isLineDue()) {
    last_line_ = view_.done;
    std::cerr << progressLine(view_, has_color_) << std::endl;
  }
}

bool ProgressDisplay::isLineDue() const {
  if (view_.total <= 0) return view_.done - last_line_ >= kPlainInterval;
  return view_.done * kPlainLines / view_.total > last_line_ * kPlainLines / view_.total;
}

void ProgressDisplay::drawBar() const {
  constexpr const char* kEraseRest = "\x1b[K";  // EL (ECMA-48): from here to the end of the line
  const ProgressLook look{columnsOf(STDERR_FILENO), has_color_};
  std::cerr << "\r" << progressBar(view_, look) << kEraseRest << std::flush;
}

}  // namespace glide::replay
