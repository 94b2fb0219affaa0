#include "replay/app/interrupt.h"

#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using Clock = std::chrono::steady_clock;

TEST(Interrupt, NotesTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.isAsked());
    std::raise(signal);
    EXPECT_TRUE(interrupt.isAsked());
  }
}

TEST(Interrupt, EndsTheProgramAtTheSecondSignal) {
  const auto signalTwice = [] {
    const Interrupt interrupt;
    std::raise(SIGTERM);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(signalTwice(), testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, LeavesTheHandlersAsTheyWere) {
  std::signal(SIGTERM, SIG_IGN);
  {
    const Interrupt interrupt;
    std::raise(SIGTERM);
    EXPECT_FALSE(interrupt.isAsked());  // ignored from the start
  }
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_IGN);
}

TEST(Interrupt, WaitsUntilATimeAndNoLongerThanUntilASignal) {
  const Interrupt interrupt;
  const Clock::time_point soon = Clock::now() + std::chrono::milliseconds(5);
  interrupt.waitUntil(soon);
  EXPECT_GE(Clock::now(), soon);
  std::raise(SIGINT);
  const Clock::time_point never = Clock::now() + std::chrono::hours(1);
  interrupt.waitUntil(never);
  EXPECT_LT(Clock::now(), never);
}

}  // namespace
}  // namespace glide::replay
