#pragma once

#include <chrono>

namespace glide {

/// Wall clock since construction or the last lap.
class Stopwatch {
 public:
  /// Milliseconds since construction or the last lap(); restarts.
  double lapMs() {
    const Clock::time_point now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return ms;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace glide
