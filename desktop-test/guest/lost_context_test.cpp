#include "guest/gl_faults.h"
#include "guest/guest_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::test {
namespace {

class LostContextTest : public GuestTest, public ::testing::WithParamInterface<WaitFault> {};

TEST_P(LostContextTest, IsLeftBehindAndTheMapIsKept) {
  Session session = makeSession(config());
  int frame = trackDirectly(&session);
  const std::vector<int> names = countNames();
  const std::size_t keyframes = session.map()->keyframes.size();
  setWaitFault(GetParam());
  const Result<FrameResult> lost = feed(&session, frame++);
  setWaitFault(WaitFault::none);
  ASSERT_TRUE(lost.ok()) << lost.error().message;
  EXPECT_EQ(lost->tracker, TrackerKind::indirect);
  EXPECT_EQ(lost->switch_reason, SwitchReason::solve_failed);
  const Result<FrameResult> rebuilt = feed(&session, frame++);
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.error().message;
  EXPECT_EQ(rebuilt->switch_reason, SwitchReason::no_reference);
  EXPECT_EQ(feed(&session, frame)->tracker, TrackerKind::direct);
  EXPECT_EQ(session.map()->resets, 0U);
  EXPECT_GE(session.map()->keyframes.size(), keyframes);
  EXPECT_EQ(countNames(), names);
}

INSTANTIATE_TEST_SUITE_P(Faults,
                         LostContextTest,
                         ::testing::Values(WaitFault::lost, WaitFault::timeout),
                         [](const auto& test) {
                           return test.param == WaitFault::lost ? "WaitFailed" : "WaitTimesOut";
                         });

}  // namespace
}  // namespace glide::test
