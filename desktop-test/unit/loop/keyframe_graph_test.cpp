#include "loop/keyframe_graph.h"

#include <gmock/gmock.h>

#include <cmath>

namespace glide {
namespace {

using testing::ElementsAre;

/// A keyframe at (x, y, 0) with its neighbours.
MapSnapshot::KeyframeEntry keyframeAt(std::uint64_t id,
                                      double x,
                                      double y,
                                      std::vector<CovisibleKeyframe> neighbors) {
  MapSnapshot::KeyframeEntry keyframe;
  keyframe.id = KeyframeId{id};
  keyframe.T_cam_world.t = -Vec3d(x, y, 0.0);
  keyframe.neighbors = std::move(neighbors);
  return keyframe;
}

CovisibleKeyframe sees(std::uint64_t id, int weight) { return {KeyframeId{id}, weight}; }

/// Three sides of a square and, without any link, a keyframe beside its last corner.
MapSnapshot threeSides() {
  MapSnapshot::Parts parts;
  parts.keyframes = {keyframeAt(1, 0, 0, {sees(2, 90), sees(3, 20)}),
                     keyframeAt(2, 1, 0, {sees(1, 90)}),
                     keyframeAt(3, 1, 1, {sees(2, 30), sees(4, 80)}),
                     keyframeAt(4, 0, 1, {}),
                     keyframeAt(5, 0, 2, {})};
  return MapSnapshot(std::move(parts));
}

std::vector<std::uint64_t> valuesOf(const std::set<KeyframeId>& ids) {
  std::vector<std::uint64_t> values;
  for (const KeyframeId id : ids) values.push_back(id.value);
  return values;
}

TEST(KeyframeGraph, ReadsNeighborsInBothDirections) {
  const MapSnapshot map = threeSides();
  const KeyframeGraph graph(map);
  EXPECT_THAT(valuesOf(graph.within(KeyframeId{4}, 0)), ElementsAre(4));
  EXPECT_THAT(valuesOf(graph.within(KeyframeId{4}, 1)), ElementsAre(3, 4));
  EXPECT_THAT(valuesOf(graph.within(KeyframeId{4}, 2)), ElementsAre(1, 2, 3, 4));
}

TEST(KeyframeGraph, JoinsPartsWithoutCallingThemCovisible) {
  const MapSnapshot map = threeSides();
  const KeyframeGraph graph(map);
  EXPECT_THAT(valuesOf(graph.within(KeyframeId{5}, 3)), ElementsAre(5));
  EXPECT_NEAR(graph.pathLength(KeyframeId{4}, KeyframeId{5}), 1.0, 1e-12);
}

TEST(KeyframeGraph, MeasuresTheShortestWay) {
  const MapSnapshot map = threeSides();
  const KeyframeGraph graph(map);
  EXPECT_NEAR(graph.pathLength(KeyframeId{1}, KeyframeId{4}), 1.0 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(graph.pathLength(KeyframeId{2}, KeyframeId{2}), 0.0, 1e-12);
  EXPECT_TRUE(std::isinf(graph.pathLength(KeyframeId{1}, KeyframeId{77})));
}

TEST(KeyframeGraph, SpansTheMapByItsStrongestLinksAndAddsStrongOnes) {
  const MapSnapshot map = threeSides();
  const KeyframeGraph graph(map);
  const auto pairsOf = [&](int min_weight) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs;
    for (const KeyframeLink& link : graph.essentialLinks(min_weight)) {
      pairs.emplace_back(link.older.value, link.newer.value);
    }
    return pairs;
  };
  using testing::Pair;
  EXPECT_THAT(pairsOf(100), ElementsAre(Pair(1, 2), Pair(2, 3), Pair(3, 4), Pair(4, 5)));
  EXPECT_THAT(pairsOf(20), ElementsAre(Pair(1, 2), Pair(1, 3), Pair(2, 3), Pair(3, 4), Pair(4, 5)));
}

}  // namespace
}  // namespace glide
