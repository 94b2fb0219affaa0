#include "render/scene_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace glide::test {
namespace {

/// Keyframes 0, 1, 2, 3 at x = id.
MapView chain() {
  MapView map;
  for (std::uint64_t id = 0; id < 4; ++id) {
    MapView::Keyframe keyframe;
    keyframe.id = id;
    keyframe.T_world_cam.t_xyz[0] = static_cast<double>(id);
    map.keyframes.push_back(keyframe);
  }
  return map;
}

/// The lines by the x of their ends, the smaller first.
std::multiset<std::pair<float, float>> lines(const std::vector<PointRecord>& records) {
  std::multiset<std::pair<float, float>> found;
  for (std::size_t i = 0; i + 1 < records.size(); i += 2) {
    const float a = records[i].p_world[0];
    const float b = records[i + 1].p_world[0];
    found.emplace(std::min(a, b), std::max(a, b));
  }
  return found;
}

using Lines = std::multiset<std::pair<float, float>>;

TEST(CovisibilityEdges, AreThereOnceForEachPair) {
  MapView map = chain();
  map.keyframes[0].covisible = {1};
  map.keyframes[1].covisible = {0, 2};
  map.keyframes[2].covisible = {1, 3};
  map.keyframes[3].covisible = {2};
  EXPECT_EQ(lines(covisibilityEdges(map, 2)), (Lines{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(CovisibilityEdges, LeadToTheBestNeighboursOnlyWhicheverSideKnowsThem) {
  MapView map = chain();
  map.keyframes[0].covisible = {3, 1};
  map.keyframes[1].covisible = {0, 2};
  map.keyframes[3].covisible = {2, 0};
  EXPECT_EQ(lines(covisibilityEdges(map, 1)), (Lines{{0, 3}, {0, 1}, {2, 3}}));
  EXPECT_TRUE(covisibilityEdges(map, 0).empty());
}

TEST(CovisibilityEdges, LeaveOutKeyframesThatAreNotThere) {
  MapView map = chain();
  map.keyframes[1].covisible = {42};
  EXPECT_TRUE(covisibilityEdges(map, 3).empty());
}

TEST(LoopEdges, AreMagentaBetweenTheTwoKeyframes) {
  MapView map = chain();
  map.keyframes[0].retired = true;  // its place is still known
  map.loops = {{3, 0}, {3, 99}};
  const std::vector<PointRecord> records = loopEdges(map);
  EXPECT_EQ(lines(records), (Lines{{0, 3}}));
  EXPECT_EQ(records[1].color, packColor(kLoopColor));
}

}  // namespace
}  // namespace glide::test
