#include "loop/placement_gates.h"

#include <gtest/gtest.h>

#include <vector>

namespace glide {
namespace {

Placement good() {
  Placement placement;
  placement.recognized = 60;
  placement.likely = 300.0;
  placement.matched = 120;
  placement.inliers = 100;
  placement.cells = 20;
  placement.median_depth = 1.0;
  placement.position_sigma = 0.001;
  return placement;
}

Placement with(int inliers) {
  Placement placement = good();
  placement.inliers = inliers;
  return placement;
}

TEST(PlacementGates, AcceptAGoodPlacement) { EXPECT_TRUE(isBeyondDoubt(good())); }

TEST(PlacementGates, RefuseWhatOnlyFitsWhereOneLooksForIt) {
  Placement placement = good();
  placement.recognized = 29;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, RefuseFewInliers) {
  Placement placement = with(39);
  placement.matched = 40;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, RefuseWhereMostOfWhatShouldBeThereIsNot) {
  Placement placement = good();
  placement.likely = 700.0;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, RefuseWhereMuchThatLooksAlikeContradicts) {
  Placement placement = good();
  placement.matched = 170;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, RefuseInliersInOneCorner) {
  Placement placement = good();
  placement.cells = 9;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, RefuseAVaguePosition) {
  Placement placement = good();
  placement.position_sigma = 0.006;
  EXPECT_FALSE(isBeyondDoubt(placement));
}

TEST(PlacementGates, CallEqualRivalsAmbiguous) {
  EXPECT_TRUE(areAmbiguous(std::vector{with(100), with(60)}));
  EXPECT_FALSE(areAmbiguous(std::vector{with(100), with(40), with(10)}));
  EXPECT_FALSE(areAmbiguous(std::vector{with(100)}));
  EXPECT_FALSE(areAmbiguous({}));
}

}  // namespace
}  // namespace glide
