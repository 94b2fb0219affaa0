#include "replay/app/frame_feed.h"

#include <utility>

namespace glide::replay {

std::optional<FedFrame> FrameFeed::next() {
  std::optional<FedFrame> fed;
  if (!interrupt_.isAsked()) fed = pace_ == Pace::realtime ? nextDue() : nextAtOnce();
  was_interrupted_ = interrupt_.isAsked() && !fed;
  return fed;
}

void FrameFeed::excuse(std::chrono::steady_clock::duration time) { start_ += time; }

std::optional<FedFrame> FrameFeed::nextAtOnce() {
  std::optional<SourceFrame> frame = source_.next();
  if (!frame) return std::nullopt;
  return FedFrame{next_index_++, std::move(*frame)};
}

std::optional<FedFrame> FrameFeed::nextDue() {
  if (!is_started_) waiting_ = takeAhead();
  is_started_ = true;
  if (!waiting_) return std::nullopt;
  SourceFrame frame = std::move(*waiting_);
  Clock::time_point due_at = due(frame);
  waiting_ = takeAhead();
  while (waiting_ && due(*waiting_) <= Clock::now()) {
    ++dropped_;
    ++next_index_;
    frame = std::move(*waiting_);
    due_at = due(frame);
    waiting_ = takeAhead();
  }
  interrupt_.waitUntil(due_at);
  if (interrupt_.isAsked()) return std::nullopt;
  return FedFrame{next_index_++, std::move(frame)};
}

std::optional<SourceFrame> FrameFeed::takeAhead() {
  const auto decode = [this] { return source_.next(); };
  if (!ahead_.valid()) ahead_ = std::async(std::launch::async, decode);
  std::optional<SourceFrame> frame = ahead_.get();
  if (frame) ahead_ = std::async(std::launch::async, decode);
  return frame;
}

FrameFeed::Clock::time_point FrameFeed::due(const SourceFrame& frame) {
  if (start_ == Clock::time_point{}) {
    start_ = Clock::now();
    start_ns_ = frame.t_ns;
  }
  return start_ + std::chrono::nanoseconds(frame.t_ns - start_ns_);
}

}  // namespace glide::replay
