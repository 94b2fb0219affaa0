#include "track/start_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr float kPitch = 40.0F;  // px from one bay to the next
constexpr std::size_t kRows = 22, kPerBay = 5, kBays = 16;

/// A wall of bays that look the same, each corner found in most frames only.
class Facade {
 public:
  Facade() {
    const auto randomBits = [&] { return Descriptor{random_(), random_(), random_(), random_()}; };
    for (std::size_t i = 0; i < kRows * kPerBay; ++i) looks_.push_back(randomBits());
  }

  /// The wall moved to the left by `shift_px`; each corner is missed with the given probability.
  FeatureSet look(float shift_px, double missed) {
    corners_.clear();
    std::vector<Feature> features;
    std::vector<Descriptor> descriptors;
    for (std::size_t k = 0; k < kRows * kPerBay * kBays; ++k) {
      const std::size_t look = k % looks_.size(), bay = k / looks_.size();
      const float x = static_cast<float>(bay) * kPitch + 8.0F * static_cast<float>(look % kPerBay);
      const float y = 10.0F + 10.0F * static_cast<float>(look / kPerBay);
      Feature feature;
      feature.uv = {x - shift_px, y};
      const bool is_missed = std::bernoulli_distribution(missed)(random_);
      if (is_missed || feature.uv.x() < 0.0F || feature.uv.x() >= kWidth) continue;
      features.push_back(feature);
      descriptors.push_back(noisy(looks_[look]));
      corners_.push_back(k);
    }
    return {std::move(features), std::move(descriptors), kWidth, kHeight};
  }

  /// Per feature of the last look.
  const std::vector<std::size_t>& corners() const { return corners_; }

 private:
  Descriptor noisy(Descriptor descriptor) {
    for (int flips = 0; flips < 12; ++flips) {
      const std::uint64_t bit = random_() % 256;
      descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
    }
    return descriptor;
  }

  std::mt19937_64 random_{3};
  std::vector<Descriptor> looks_;
  std::vector<std::size_t> corners_;
};

CameraModel camera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = kWidth;
  intrinsics.height = kHeight;
  intrinsics.fx = intrinsics.fy = 260.0;
  intrinsics.cx = 159.5;
  intrinsics.cy = 119.5;
  return CameraModel::create(intrinsics).value();
}

TEST(StartTracks, DoNotHopToTheNextBayOfAFacade) {
  constexpr double kMissed = 0.3;
  constexpr float kStep_px = 3.0F;
  Facade facade;
  StartTracks tracks(camera());
  tracks.start(std::make_shared<const FeatureSet>(facade.look(0.0F, kMissed)));
  const std::vector<std::size_t> first = facade.corners();
  for (int frame = 1; frame <= 30; ++frame) {  // more than two bays
    const FeatureSet now = facade.look(kStep_px * static_cast<float>(frame), kMissed);
    const std::vector<Match> matches = tracks.follow(now);
    const auto wrong = std::count_if(matches.begin(), matches.end(), [&](const Match& match) {
      return first[static_cast<std::size_t>(match.a)] !=
             facade.corners()[static_cast<std::size_t>(match.b)];
    });
    ASSERT_EQ(wrong, 0) << "frame " << frame;
    ASSERT_GT(matches.size(), 200U) << "frame " << frame;
  }
}

TEST(StartTracks, FollowAMotionOfTensOfPixels) {
  Facade facade;
  StartTracks tracks(camera());
  tracks.start(std::make_shared<const FeatureSet>(facade.look(0.0F, 0.0)));
  const std::vector<Match> matches = tracks.follow(facade.look(0.4F * kPitch, 0.0));
  EXPECT_GT(matches.size(), 200U);
}

}  // namespace
}  // namespace glide
