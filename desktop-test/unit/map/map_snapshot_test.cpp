#include "map/map_snapshot.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

TEST(MapSnapshot, IsEmptyWhenDefaultConstructed) {
  const MapSnapshot snapshot;
  EXPECT_TRUE(snapshot.empty());
  EXPECT_EQ(snapshot.revision(), 0U);
  EXPECT_EQ(snapshot.keyframe(KeyframeId{0}), nullptr);
  EXPECT_EQ(snapshot.landmark(LandmarkId{0}), nullptr);
  EXPECT_FALSE(snapshot.T_cam_world(KeyframeId{0}).has_value());
}

TEST(MapSnapshot, FindsWhatItHoldsAndNothingElse) {
  std::vector<MapSnapshot::KeyframeEntry> keyframes(2);
  keyframes[0].id = KeyframeId{3};
  keyframes[1].id = KeyframeId{8};
  keyframes[1].T_cam_world.t.x() = 8.0;
  std::vector<MapSnapshot::LandmarkEntry> landmarks(2);
  landmarks[0].id = LandmarkId{10};
  landmarks[1].id = LandmarkId{40};
  MapSnapshot::Parts parts;
  parts.revision = 2;
  parts.keyframes = std::move(keyframes);
  parts.landmarks = std::move(landmarks);
  parts.retired.emplace_back().id = KeyframeId{5};
  const MapSnapshot snapshot(std::move(parts));
  EXPECT_EQ(snapshot.keyframe(KeyframeId{8})->id, KeyframeId{8});
  EXPECT_EQ(snapshot.keyframe(KeyframeId{5}), nullptr);
  EXPECT_EQ(snapshot.keyframe(KeyframeId{9}), nullptr);
  EXPECT_EQ(snapshot.landmark(LandmarkId{40})->id, LandmarkId{40});
  EXPECT_EQ(snapshot.landmark(LandmarkId{11}), nullptr);
  EXPECT_DOUBLE_EQ(snapshot.T_cam_world(KeyframeId{8})->t.x(), 8.0);
  EXPECT_TRUE(snapshot.T_cam_world(KeyframeId{5}).has_value());
  EXPECT_FALSE(snapshot.T_cam_world(KeyframeId{4}).has_value());
}

}  // namespace
}  // namespace glide
