#include "mapping/recent_landmarks.h"

#include <gtest/gtest.h>

#include <memory>

namespace glide {
namespace {

class RecentLandmarksTest : public testing::Test {
 protected:
  RecentLandmarksTest() {
    for (std::uint64_t id = 0; id < 4; ++id) {
      Keyframe keyframe;
      keyframe.id = KeyframeId{id};
      keyframe.features = std::make_shared<FeatureSet>(
          std::vector<Feature>(4), std::vector<Descriptor>(4), 640, 480);
      map_.addKeyframe(keyframe);
    }
  }

  LandmarkId create(int feature) {
    const LandmarkId id = map_.addLandmark(Vec3d::UnitZ(), KeyframeId{0});
    map_.addObservation(id, {KeyframeId{0}, feature});
    map_.addObservation(id, {KeyframeId{1}, feature});
    return id;
  }

  Map map_{ScaleLevels(1.2, 8)};
  RecentLandmarks recent_;
};

TEST_F(RecentLandmarksTest, RemovesWhatTrackingHardlyEverFinds) {
  const LandmarkId good = create(0);
  const LandmarkId bad = create(1);
  recent_.add({good, bad});
  map_.countSighting({good, 10, 9});
  map_.countSighting({bad, 10, 1});
  recent_.cull(&map_);
  EXPECT_NE(map_.landmark(good), nullptr);
  EXPECT_EQ(map_.landmark(bad), nullptr);
}

TEST_F(RecentLandmarksTest, RemovesWhatNoFurtherKeyframeSees) {
  const LandmarkId seen = create(0);
  const LandmarkId unseen = create(1);
  recent_.add({seen, unseen});
  recent_.cull(&map_);
  EXPECT_NE(map_.landmark(unseen), nullptr);  // one keyframe later: still on probation
  map_.addObservation(seen, {KeyframeId{2}, 0});
  recent_.cull(&map_);
  EXPECT_NE(map_.landmark(seen), nullptr);
  EXPECT_EQ(map_.landmark(unseen), nullptr);
}

TEST_F(RecentLandmarksTest, LeavesReleasedLandmarksAlone) {
  const LandmarkId id = create(0);
  recent_.add({id});
  map_.addObservation(id, {KeyframeId{2}, 0});
  for (int i = 0; i < 3; ++i) recent_.cull(&map_);
  map_.countSighting({id, 1000, 0});
  recent_.cull(&map_);
  EXPECT_NE(map_.landmark(id), nullptr);
}

TEST_F(RecentLandmarksTest, IgnoresLandmarksThatWereFusedMeanwhile) {
  const LandmarkId id = create(0);
  recent_.add({id});
  map_.removeLandmark(id);
  recent_.cull(&map_);
  EXPECT_EQ(map_.landmarkCount(), 0U);
}

}  // namespace
}  // namespace glide
