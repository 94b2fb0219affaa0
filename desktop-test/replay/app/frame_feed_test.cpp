#include "replay/app/frame_feed.h"

#include "replay/app/progress_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

std::vector<int> indices(FrameFeed& feed) {
  std::vector<int> result;
  while (const auto fed = feed.next()) result.push_back(fed->index);
  return result;
}

TEST(FrameFeed, LosslessGivesEveryFrame) {
  ListedSource source({0, 1, 2, 3});
  FrameFeed feed(source, Pace::lossless);
  EXPECT_THAT(indices(feed), testing::ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(feed.dropped(), 0);
}

TEST(FrameFeed, RealtimeDropsFramesWhoseSuccessorIsAlreadyDue) {
  ListedSource source({0, 1, 2, 3});  // a nanosecond apart: all due at once
  FrameFeed feed(source, Pace::realtime);
  EXPECT_THAT(indices(feed), testing::ElementsAre(3));
  EXPECT_EQ(feed.dropped(), 3);
}

TEST(FrameFeed, RealtimeWaitsUntilAFrameIsDue) {
  constexpr std::int64_t kStep = 30'000'000;
  ListedSource source({5 * kStep, 6 * kStep});
  FrameFeed feed(source, Pace::realtime);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(feed.next().has_value());
  EXPECT_TRUE(feed.next().has_value());
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::nanoseconds(kStep));
  EXPECT_FALSE(feed.next().has_value());
  EXPECT_FALSE(feed.next().has_value());
}

TEST(FrameFeed, RealtimeEndsAtOnceWithoutFrames) {
  ListedSource source({});
  FrameFeed feed(source, Pace::realtime);
  EXPECT_FALSE(feed.next().has_value());
}

TEST(Progress, ShowsABarOnlyWhenTheEndIsKnown) {
  ProgressView view{50, 100, 40, 45, 2.0, TrackingState::tracking};
  const std::string bar = progressBar(view);
  EXPECT_THAT(bar, testing::StartsWith("[===============>"));
  EXPECT_THAT(bar, testing::HasSubstr("50/100 frames  25.0 fps  tracking"));
  EXPECT_THAT(bar, testing::HasSubstr("direct 89 %"));
  view.total = 0;
  EXPECT_THAT(progressBar(view), testing::StartsWith("50 frames"));
}

}  // namespace
}  // namespace glide::replay
