#include "map/map_restore.h"

#include "support/small_map.h"

#include "map/map_consistency.h"
#include "map/snapshot_builder.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::smallMap;
using test::storedSmallMap;

std::vector<std::byte> bytesOfMap(const Map& map) {
  SnapshotStamp stamp;
  stamp.revision = 17;
  StoredMap stored = storedSmallMap({});
  stored.map = snapshotOf(map, stamp);
  return encodeMap(stored);
}

TEST(RestoreMap, MakesTheMapThatWasRecorded) {
  const Map before = smallMap({});
  Map after(before.levels());
  restoreMap(*storedSmallMap({}).map, &after);
  EXPECT_EQ(checkConsistency(after), "");
  EXPECT_EQ(bytesOfMap(after), bytesOfMap(before));
  const KeyframeId first = before.keyframes().begin()->first;
  const KeyframeId last = before.keyframes().rbegin()->first;
  EXPECT_GT(after.covisibility().weight(first, last), 0);
  EXPECT_EQ(after.covisibility().weight(first, last), before.covisibility().weight(first, last));
}

TEST(RestoreMap, LeavesSummariesAsTheyWereRecorded) {
  Map map = smallMap({});
  restoreMap(*storedSmallMap({}).map, &map);
  const std::vector<std::byte> before = bytesOfMap(map);
  map.refreshChanged();
  EXPECT_EQ(bytesOfMap(map), before);
}

TEST(RestoreMap, ReplacesWhatWasThere) {
  test::SmallMapOptions other;
  other.seed = 5;
  other.keyframes = 7;
  Map map = smallMap(other);
  restoreMap(*storedSmallMap({}).map, &map);
  EXPECT_EQ(checkConsistency(map), "");
  EXPECT_EQ(bytesOfMap(map), bytesOfMap(smallMap({})));
}

TEST(RestoreMap, GivesNewLandmarksIdsAboveTheRecordedOnes) {
  Map map(ScaleLevels(1.2, 8));
  restoreMap(*storedSmallMap({}).map, &map);
  const LandmarkId newest = map.landmarkIds().back();
  EXPECT_LT(newest, map.addLandmark(Vec3d::Zero(), map.keyframes().begin()->first));
}

TEST(RestoreLandmark, RefusesWhatCannotBe) {
  Map map = smallMap({});
  const std::size_t count = map.landmarkCount();
  const KeyframeId keyframe = map.keyframes().begin()->first;
  Landmark landmark = *map.landmark(map.landmarkIds().back());
  EXPECT_FALSE(map.restoreLandmark(landmark));  // the id is taken
  landmark.id.value += 10;
  EXPECT_FALSE(map.restoreLandmark(landmark));  // its features hold a landmark
  landmark.observations = {{keyframe, 1000, 0}};
  EXPECT_FALSE(map.restoreLandmark(landmark));  // no such feature
  landmark.id = kNoLandmark;
  landmark.observations.clear();
  EXPECT_FALSE(map.restoreLandmark(landmark));
  EXPECT_EQ(map.landmarkCount(), count);
  EXPECT_EQ(checkConsistency(map), "");
}

TEST(RestoreRetired, RefusesTakenIdsAndMissingParents) {
  Map map = smallMap({});
  const RetiredKeyframe retired = map.retired().begin()->second;
  EXPECT_FALSE(map.restoreRetired(retired));
  RetiredKeyframe other = retired;
  other.id = map.keyframes().begin()->first;
  EXPECT_FALSE(map.restoreRetired(other));
  other.id = KeyframeId{1000};
  other.parent = retired.id;
  EXPECT_FALSE(map.restoreRetired(other));
  other.parent = retired.parent;
  EXPECT_TRUE(map.restoreRetired(other));
}

}  // namespace
}  // namespace glide
