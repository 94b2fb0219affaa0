#include "replay/app/interrupt.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace glide::replay {
namespace {

// A signal handler can reach nothing but a static; this is the only one.
std::atomic<bool> is_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

extern "C" void noteSignal(int) {
  is_asked.store(true);
  std::signal(SIGINT, SIG_DFL);  // the next one is not waited for
  std::signal(SIGTERM, SIG_DFL);
}

void handle(int signal, struct sigaction* before) {
  struct sigaction action {};
  action.sa_handler = noteSignal;
  action.sa_flags = SA_RESTART;  // reads and writes go on
  sigaction(signal, nullptr, before);
  if (before->sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  is_asked.store(false);
  handle(SIGINT, &before_int_);
  handle(SIGTERM, &before_term_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &before_int_, nullptr);
  sigaction(SIGTERM, &before_term_, nullptr);
}

bool Interrupt::isAsked() const { return isInterrupted(); }

bool isInterrupted() { return is_asked.load(); }

void Interrupt::waitUntil(std::chrono::steady_clock::time_point time) const {
  using Clock = std::chrono::steady_clock;
  // sleep_until goes on sleeping after a signal: how long a person may wait for an answer.
  constexpr std::chrono::milliseconds kLongest{50};
  for (Clock::time_point now = Clock::now(); now < time && !isAsked(); now = Clock::now()) {
    std::this_thread::sleep_until(std::min(time, now + kLongest));
  }
}

}  // namespace glide::replay
