#include "replay/app/frame_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <thread>
#include <vector>

namespace glide::replay {
namespace {

/// Frames with the given times and no pixels.
class ListedSource : public FrameSource {
 public:
  explicit ListedSource(std::vector<std::int64_t> times_ns) : times_ns_(std::move(times_ns)) {}
  const SourceInfo& info() const override { return info_; }
  const SkipList& skips() const override { return skips_; }
  std::optional<SourceFrame> next() override {
    if (next_ == times_ns_.size()) return std::nullopt;
    SourceFrame frame;
    frame.t_ns = times_ns_[next_++];
    return frame;
  }

 private:
  std::vector<std::int64_t> times_ns_;
  std::size_t next_ = 0;
  SourceInfo info_;
  SkipList skips_;
};

class FrameFeedTest : public testing::Test {
 protected:
  const Interrupt interrupt_;
};

std::vector<int> indices(FrameFeed& feed) {
  std::vector<int> result;
  while (const auto fed = feed.next()) result.push_back(fed->index);
  return result;
}

TEST_F(FrameFeedTest, LosslessGivesEveryFrame) {
  ListedSource source({0, 1, 2, 3});
  FrameFeed feed(source, Pace::lossless, interrupt_);
  EXPECT_THAT(indices(feed), testing::ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(feed.dropped(), 0);
}

TEST_F(FrameFeedTest, RealtimeDropsFramesWhoseSuccessorIsAlreadyDue) {
  ListedSource source({0, 1, 2, 3});  // a nanosecond apart: all due at once
  FrameFeed feed(source, Pace::realtime, interrupt_);
  EXPECT_THAT(indices(feed), testing::ElementsAre(3));
  EXPECT_EQ(feed.dropped(), 3);
}

TEST_F(FrameFeedTest, RealtimeWaitsUntilAFrameIsDue) {
  constexpr std::int64_t kStep = 30'000'000;
  ListedSource source({5 * kStep, 6 * kStep});
  FrameFeed feed(source, Pace::realtime, interrupt_);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(feed.next().has_value());
  EXPECT_TRUE(feed.next().has_value());
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::nanoseconds(kStep));
  EXPECT_FALSE(feed.next().has_value());
  EXPECT_FALSE(feed.next().has_value());
}

TEST_F(FrameFeedTest, RealtimeMovesWhatIsDueByTimeThatIsExcused) {
  constexpr std::int64_t kHour = 3'600'000'000'000;
  ListedSource source({0, kHour, 2 * kHour});
  FrameFeed feed(source, Pace::realtime, interrupt_);
  EXPECT_TRUE(feed.next().has_value());
  feed.excuse(-std::chrono::hours(1));  // as if an hour of tracking had passed
  EXPECT_EQ(feed.next()->index, 1);
  EXPECT_EQ(feed.dropped(), 0);
}

TEST_F(FrameFeedTest, RealtimeEndsAtOnceWithoutFrames) {
  ListedSource source({});
  FrameFeed feed(source, Pace::realtime, interrupt_);
  EXPECT_FALSE(feed.next().has_value());
}

TEST_F(FrameFeedTest, EndsWhenItIsInterrupted) {
  ListedSource lossless({0, 1, 2});
  FrameFeed feed(lossless, Pace::lossless, interrupt_);
  EXPECT_TRUE(feed.next().has_value());
  EXPECT_FALSE(feed.wasInterrupted());
  std::raise(SIGINT);
  EXPECT_FALSE(feed.next().has_value());
  EXPECT_TRUE(feed.wasInterrupted());
}

TEST_F(FrameFeedTest, EndsWhenItIsInterruptedWhileItWaitsForAFrame) {
  constexpr std::int64_t kHour = 3'600'000'000'000;
  ListedSource source({0, kHour});
  FrameFeed feed(source, Pace::realtime, interrupt_);
  EXPECT_TRUE(feed.next().has_value());
  std::thread person([] { std::raise(SIGTERM); });
  EXPECT_FALSE(feed.next().has_value());
  EXPECT_TRUE(feed.wasInterrupted());
  person.join();
}

}  // namespace
}  // namespace glide::replay
