#pragma once

#include <chrono>
#include <csignal>

namespace glide::replay {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM is only noted; the one after it ends the
/// program as ever. A signal that the program was started to ignore stays ignored (nohup, "&" in a
/// script). At most one at a time: signal handlers belong to the process.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool isAsked() const;
  /// Returns at `time`, or as soon as a signal has come.
  void waitUntil(std::chrono::steady_clock::time_point time) const;

 private:
  struct sigaction before_int_ {};
  struct sigaction before_term_ {};
};

/// Whether such a signal has come, also to who waits far from the Interrupt.
bool isInterrupted();

}  // namespace glide::replay
