#pragma once

#include <cstdint>
#include <span>

namespace glide::replay {

/// The rate of frames at these times (at least two, increasing), per second: from the median
/// interval, within what video files are made for.
double frameRate(std::span<const std::int64_t> times_ns);

/// Lays frames with timestamps onto the even steps of a video, so that it plays in real time:
/// one step each, as long as that stays within a step of the truth.
class FramePacer {
 public:
  FramePacer(double frames_per_s, std::int64_t first_ns)
      : rate_(frames_per_s), first_ns_(first_ns) {}

  /// How many steps end with the frame of this time: none when the video is ahead; of several the
  /// frame before fills all but the last. A gap is shown as ten seconds at most.
  int steps(std::int64_t t_ns);

 private:
  double rate_;
  std::int64_t first_ns_;
  std::int64_t written_ = 0;
  double cut_s_ = 0.0;  ///< of gaps that were longer
};

}  // namespace glide::replay
