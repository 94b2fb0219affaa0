#include "map/covisibility.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

constexpr KeyframeId kA{1}, kB{2}, kC{3}, kD{4};

TEST(Covisibility, IsSymmetricAndAddsUp) {
  Covisibility covisibility;
  covisibility.change(kA, kB, 1);
  covisibility.change(kB, kA, 2);
  EXPECT_EQ(covisibility.weight(kA, kB), 3);
  EXPECT_EQ(covisibility.weight(kB, kA), 3);
  EXPECT_EQ(covisibility.weight(kA, kC), 0);
}

TEST(Covisibility, ForgetsAPairThatSharesNothing) {
  Covisibility covisibility;
  covisibility.change(kA, kB, 2);
  covisibility.change(kA, kB, -2);
  EXPECT_EQ(covisibility.weight(kA, kB), 0);
  EXPECT_TRUE(covisibility.neighbors(kA, 0).empty());
}

TEST(Covisibility, ListsNeighborsBestFirstAndOlderFirstAmongEquals) {
  Covisibility covisibility;
  covisibility.change(kA, kD, 5);
  covisibility.change(kA, kB, 5);
  covisibility.change(kA, kC, 9);
  const std::vector<CovisibleKeyframe> neighbors = covisibility.neighbors(kA, 1);
  ASSERT_EQ(neighbors.size(), 3U);
  EXPECT_EQ(neighbors[0].id, kC);
  EXPECT_EQ(neighbors[1].id, kB);
  EXPECT_EQ(neighbors[2].id, kD);
}

TEST(Covisibility, FallsBackToTheBestNeighborWhenAllAreWeak) {
  Covisibility covisibility;
  covisibility.change(kA, kB, 2);
  covisibility.change(kA, kC, 4);
  const std::vector<CovisibleKeyframe> neighbors = covisibility.neighbors(kA, 15);
  ASSERT_EQ(neighbors.size(), 1U);
  EXPECT_EQ(neighbors[0].id, kC);
  EXPECT_TRUE(covisibility.neighbors(kD, 15).empty());
}

}  // namespace
}  // namespace glide
