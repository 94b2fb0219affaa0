#pragma once

#include "replay/app/interrupt.h"
#include "replay/outputs/run_record.h"
#include "replay/readers/frame_source.h"

#include <chrono>
#include <cstdint>
#include <future>
#include <optional>

namespace glide::replay {

/// A frame with its position among all that the source delivered.
struct FedFrame {
  int index = 0;
  SourceFrame frame;
};

/// Hands out the frames of a source at a pace. Lossless: each at once, decoded when asked for, so
/// that decoding does not disturb the tracker's times. Realtime: each when its timestamp is due,
/// decoded ahead on a helper thread; a frame whose successor is already due is dropped, as a camera
/// that keeps only the newest image would.
class FrameFeed {
 public:
  FrameFeed(FrameSource& source, Pace pace, const Interrupt& interrupt)
      : source_(source), pace_(pace), interrupt_(interrupt) {}

  /// Nothing at the end of the source, and when the program is interrupted.
  std::optional<FedFrame> next();
  /// The tracker was not asked for so long, for instance because a viewer was paused: in realtime
  /// the frames are due that much later.
  void excuse(std::chrono::steady_clock::duration time);
  int dropped() const { return dropped_; }
  /// Whether there might have been more frames.
  bool wasInterrupted() const { return was_interrupted_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<FedFrame> nextAtOnce();
  std::optional<FedFrame> nextDue();
  std::optional<SourceFrame> takeAhead();
  Clock::time_point due(const SourceFrame& frame);

  FrameSource& source_;
  const Pace pace_;
  const Interrupt& interrupt_;
  bool was_interrupted_ = false;
  int next_index_ = 0;
  int dropped_ = 0;
  bool is_started_ = false;
  std::future<std::optional<SourceFrame>> ahead_;
  std::optional<SourceFrame> waiting_;  ///< taken from ahead_ but not due yet
  Clock::time_point start_;
  std::int64_t start_ns_ = 0;
};

}  // namespace glide::replay
