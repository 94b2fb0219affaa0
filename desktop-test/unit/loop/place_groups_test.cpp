#include "loop/place_groups.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace glide {
namespace {

/// Keyframes 0, 1, ...: each is covisible with the next and the one before, but 4 and 5 are not.
MapSnapshot chainOf(std::uint64_t count) {
  MapSnapshot::Parts parts;
  for (std::uint64_t k = 0; k < count; ++k) {
    MapSnapshot::KeyframeEntry entry;
    entry.id = KeyframeId{k};
    if (k > 0 && k != 5) entry.neighbors.push_back({KeyframeId{k - 1}, 100});
    if (k + 1 < count && k != 4) entry.neighbors.push_back({KeyframeId{k + 1}, 50});
    parts.keyframes.push_back(entry);
  }
  return MapSnapshot(std::move(parts));
}

PlaceMatch match(std::uint64_t keyframe, double score) {
  return {KeyframeId{keyframe}, static_cast<int>(1000 * score), score};
}

std::vector<std::uint64_t> idsOf(const PlaceGroup& group) {
  std::vector<std::uint64_t> ids;
  for (const auto* keyframe : group.keyframes) ids.push_back(keyframe->id.value);
  return ids;
}

using Ids = std::vector<std::uint64_t>;

TEST(PlaceGroups, PutsNeighborsTogether) {
  const MapSnapshot map = chainOf(10);
  const std::vector<PlaceMatch> matches = {match(2, 0.5), match(8, 0.4), match(3, 0.3)};
  const auto groups = groupPlaces(map, matches, PlaceGroupLimits{});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(idsOf(groups[0]), (Ids{2, 3}));
  EXPECT_EQ(idsOf(groups[1]), (Ids{8}));
}

TEST(PlaceGroups, PutsThePlaceFirstThatMoreKeyframesAgreeOn) {
  const MapSnapshot map = chainOf(10);
  const std::vector<PlaceMatch> matches = {match(8, 0.4), match(2, 0.3), match(3, 0.3)};
  const auto groups = groupPlaces(map, matches, PlaceGroupLimits{});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(idsOf(groups[0]), (Ids{2, 3}));
  EXPECT_NEAR(groups[0].score, 0.6, 1e-12);
}

TEST(PlaceGroups, KeepsApartWhatSharesNothing) {
  const MapSnapshot map = chainOf(10);
  const std::vector<PlaceMatch> matches = {match(4, 0.5), match(5, 0.4)};
  EXPECT_EQ(groupPlaces(map, matches, PlaceGroupLimits{}).size(), 2U);
}

TEST(PlaceGroups, PassesOverKeyframesThatTheMapHasNot) {
  const MapSnapshot map = chainOf(3);
  const std::vector<PlaceMatch> matches = {match(70, 0.9), match(1, 0.2)};
  const auto groups = groupPlaces(map, matches, PlaceGroupLimits{});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(idsOf(groups[0]), (Ids{1}));
}

TEST(PlaceGroups, RespectsItsLimits) {
  const MapSnapshot map = chainOf(10);
  const std::vector<PlaceMatch> matches = {
      match(1, 0.5), match(0, 0.4), match(2, 0.4), match(4, 0.3), match(6, 0.2), match(8, 0.1)};
  PlaceGroupLimits limits;
  limits.max_groups = 2;
  limits.max_keyframes = 2;
  const auto groups = groupPlaces(map, matches, limits);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(idsOf(groups[0]), (Ids{1, 0}));
  EXPECT_NEAR(groups[0].score, 1.3, 1e-12);  // what found no room still speaks for the place
  limits.max_neighbors = 1;                  // of keyframe 1 only the first counts
  EXPECT_EQ(idsOf(groupPlaces(map, matches, limits)[0]), (Ids{1, 0}));
  EXPECT_NEAR(groupPlaces(map, matches, limits)[0].score, 0.9, 1e-12);
}

}  // namespace
}  // namespace glide
