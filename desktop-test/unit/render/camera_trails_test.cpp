#include "render/camera_trails.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

TrackedPoint pointAt(std::uint64_t landmark, float u) {
  TrackedPoint point;
  point.landmark = landmark;
  point.u = u;
  point.v = 2.0F * u;
  return point;
}

/// Adds a picture with landmark 1 at u = `frame` for each of `frames` frames.
void follow(PointTrails* trails, int frames) {
  for (int frame = 0; frame < frames; ++frame)
    trails->add(std::vector<TrackedPoint>{pointAt(1, static_cast<float>(frame))});
}

TEST(PointTrails, BeginWithTheNewestPosition) {
  PointTrails trails;
  follow(&trails, 3);
  const PointTrails::Trail trail = trails.of(1);
  ASSERT_EQ(trail.count, 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(trail.uv[i][0], 2.0F - static_cast<float>(i));
  EXPECT_EQ(trail.uv[0][1], 4.0F);
}

TEST(PointTrails, AreNoLongerThanTenSteps) {
  PointTrails trails;
  follow(&trails, 40);
  const PointTrails::Trail trail = trails.of(1);
  ASSERT_EQ(trail.count, PointTrails::kLength + 1);
  EXPECT_EQ(trail.uv[0][0], 39.0F);
  EXPECT_EQ(trail.uv[PointTrails::kLength][0], 29.0F);
}

TEST(PointTrails, BridgePicturesInWhichTheLandmarkWasNotSeen) {
  PointTrails trails;
  follow(&trails, 2);
  trails.add(std::vector<TrackedPoint>{pointAt(2, 7.0F)});
  trails.add(std::vector<TrackedPoint>{pointAt(1, 5.0F)});
  const PointTrails::Trail trail = trails.of(1);
  ASSERT_EQ(trail.count, 3U);
  EXPECT_EQ(trail.uv[0][0], 5.0F);
  EXPECT_EQ(trail.uv[1][0], 1.0F);
}

TEST(PointTrails, ForgetLandmarksThatWereNotSeenForLong) {
  PointTrails trails;
  trails.add(std::vector<TrackedPoint>{pointAt(2, 7.0F)});
  follow(&trails, 10);
  EXPECT_EQ(trails.size(), 2U);
  follow(&trails, 1);
  EXPECT_EQ(trails.size(), 1U);
  EXPECT_EQ(trails.of(2).count, 0U);
}

TEST(PointTrails, DoNotGrowWhenAPictureIsDrawnAgain) {
  PointTrails trails;
  follow(&trails, 3);
  for (int again = 0; again < 20; ++again) trails.add(std::vector<TrackedPoint>{pointAt(1, 2.0F)});
  EXPECT_EQ(trails.of(1).count, 3U);
}

TEST(PointTrails, DoNotReachAcrossALoss) {
  PointTrails trails;
  follow(&trails, 5);
  for (std::size_t lost = 0; lost <= PointTrails::kLength; ++lost) trails.add({});
  EXPECT_EQ(trails.size(), 0U);
  trails.add(std::vector<TrackedPoint>{pointAt(1, 300.0F)});
  EXPECT_EQ(trails.of(1).count, 1U);
}

TEST(PointTrails, OfNothingAreEmpty) {
  PointTrails trails;
  trails.add({});
  EXPECT_EQ(trails.of(1).count, 0U);
}

}  // namespace
}  // namespace glide::test
