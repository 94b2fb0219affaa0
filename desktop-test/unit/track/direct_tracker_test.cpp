#include "track/direct_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace glide {
namespace {

using ::testing::ElementsAre;

/// An aligner on a device that can be taken away; tells what happens to it.
class FakeAligner final : public Aligner {
 public:
  FakeAligner(const bool* device_lives, std::vector<std::string>* events)
      : device_lives_(device_lives), events_(events) {}
  ~FakeAligner() override { events_->push_back("destroyed"); }

  Status loadFrame(const FrameImage&) override { return Unit{}; }
  void promoteReference(std::span<const AlignPoint>) override {}
  bool hasReference() const override { return false; }
  AlignResult align(const SE3d&) override { return {}; }
  bool isUsable() const override { return *device_lives_; }
  void abandon() override { events_->push_back("abandoned"); }
  AlignTimes times() const override { return {}; }
  StageTimer timer() const override { return StageTimer::cpu; }

 private:
  const bool* device_lives_;
  std::vector<std::string>* events_;
};

class DirectTrackerTest : public ::testing::Test {
 protected:
  std::unique_ptr<Aligner> makeAligner() {
    return std::make_unique<FakeAligner>(&device_lives_, &events_);
  }
  bool device_lives_ = true;
  std::vector<std::string> events_;
  DirectTracker tracker_{Config::Direct{}, makeAligner()};
};

TEST_F(DirectTrackerTest, IsUsableAsLongAsItsAlignerIs) {
  EXPECT_TRUE(tracker_.isUsable());
  device_lives_ = false;
  EXPECT_FALSE(tracker_.isUsable());
  device_lives_ = true;
  tracker_.releaseAligner();
  EXPECT_FALSE(tracker_.isUsable());
  tracker_.setAligner(makeAligner());
  EXPECT_TRUE(tracker_.isUsable());
}

TEST_F(DirectTrackerTest, ReleasesTheAlignerByItsDestruction) {
  tracker_.releaseAligner();
  tracker_.releaseAligner();
  EXPECT_THAT(events_, ElementsAre("destroyed"));
}

TEST_F(DirectTrackerTest, AbandonsTheAlignerBeforeItGoes) {
  tracker_.abandonAligner();
  tracker_.abandonAligner();
  EXPECT_THAT(events_, ElementsAre("abandoned", "destroyed"));
}

}  // namespace
}  // namespace glide
