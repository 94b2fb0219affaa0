#include "map/local_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace glide {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Keyframes 0 to 9; landmarks k and 100 + k are seen by keyframes k and k + 1 (the last by one).
MapSnapshot chain() {
  MapSnapshot::Parts parts;
  for (std::uint64_t k = 0; k < 10; ++k) {
    MapSnapshot::KeyframeEntry keyframe;
    keyframe.id = KeyframeId{k};
    keyframe.landmarks = {LandmarkId{k}, kNoLandmark, LandmarkId{100 + k}};
    if (k > 0)
      keyframe.landmarks.insert(keyframe.landmarks.end(), {LandmarkId{k - 1}, LandmarkId{99 + k}});
    if (k > 0) keyframe.neighbors.push_back({KeyframeId{k - 1}, 2});
    if (k < 9) keyframe.neighbors.push_back({KeyframeId{k + 1}, 2});
    parts.keyframes.push_back(keyframe);
  }
  for (const std::uint64_t base : {0, 100}) {
    for (std::uint64_t k = 0; k < 10; ++k) {
      MapSnapshot::LandmarkEntry landmark;
      landmark.id = LandmarkId{base + k};
      landmark.p_world = landmark.normal = Vec3d::Zero();
      landmark.observations.push_back({KeyframeId{k}, 0, 0});
      if (k < 9) landmark.observations.push_back({KeyframeId{k + 1}, 3, 0});
      parts.landmarks.push_back(landmark);
    }
  }
  return MapSnapshot(std::move(parts));
}

std::set<std::uint64_t> idsOf(const LocalMap& local) {
  std::set<std::uint64_t> ids;
  for (const auto* landmark : local.landmarks) ids.insert(landmark->id.value);
  return ids;
}

TEST(LocalMap, IsWhatKeyframesAndTheirNeighborsSee) {
  const MapSnapshot map = chain();
  const std::vector<LandmarkId> seen = {LandmarkId{4}, kNoLandmark, LandmarkId{105}};
  const LocalMap local = collectLocalMap(map, seen, LocalMapLimits{});
  EXPECT_EQ(local.reference, KeyframeId{5});  // the one that sees both
  EXPECT_EQ(local.reference_landmarks, 4);
  // Keyframes 4, 5, 6 see one of them; 3 and 7 are their neighbours.
  EXPECT_EQ(idsOf(local),
            (std::set<std::uint64_t>{2, 3, 4, 5, 6, 7, 102, 103, 104, 105, 106, 107}));
}

TEST(LocalMap, HoldsEachLandmarkOnce) {
  const MapSnapshot map = chain();
  const LocalMap local = collectLocalMap(map, std::vector{LandmarkId{4}}, LocalMapLimits{});
  EXPECT_EQ(local.landmarks.size(), idsOf(local).size());
}

TEST(LocalMap, KeepsToItsLimits) {
  const MapSnapshot map = chain();
  const std::vector<LandmarkId> seen = {LandmarkId{4}, LandmarkId{5}};
  EXPECT_EQ(idsOf(collectLocalMap(map, seen, {1, 100})), (std::set<std::uint64_t>{4, 5, 104, 105}));
  EXPECT_EQ(collectLocalMap(map, seen, {20, 3}).landmarks.size(), 3U);
}

TEST(LocalMap, IsEmptyWhereNothingIsSeen) {
  const MapSnapshot map = chain();
  EXPECT_THAT(collectLocalMap(map, {}, LocalMapLimits{}).landmarks, IsEmpty());
  const std::vector<LandmarkId> unknown = {kNoLandmark, LandmarkId{55}};
  EXPECT_THAT(collectLocalMap(map, unknown, LocalMapLimits{}).landmarks, IsEmpty());
  EXPECT_THAT(landmarksOf(map, unknown), IsEmpty());
}

TEST(LocalMap, FindsTheLandmarksOfFeatures) {
  const MapSnapshot map = chain();
  const auto found = landmarksOf(map, map.keyframe(KeyframeId{0})->landmarks);
  EXPECT_THAT(found, ElementsAre(map.landmark(LandmarkId{0}), map.landmark(LandmarkId{100})));
}

}  // namespace
}  // namespace glide
