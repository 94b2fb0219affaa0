#include "map/landmark.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide {
namespace {

TEST(ScaleLevels, GrowGeometricallyAndClamp) {
  const ScaleLevels levels(1.2, 8);
  EXPECT_DOUBLE_EQ(levels.scale(0), 1.0);
  EXPECT_NEAR(levels.scale(3), std::pow(1.2, 3), 1e-12);
  EXPECT_DOUBLE_EQ(levels.scale(-1), levels.scale(0));
  EXPECT_DOUBLE_EQ(levels.scale(99), levels.scale(7));
}

TEST(PredictedLevel, IsTheObservedLevelAtTheObservedDistance) {
  const ScaleLevels levels(1.2, 8);
  for (int level = 0; level < levels.count(); ++level) {
    const double distance = 3.7;
    EXPECT_EQ(predictedLevel(levels, distance * levels.scale(level), distance), level);
  }
}

TEST(PredictedLevel, CoarsensAsTheCameraApproaches) {
  const ScaleLevels levels(1.2, 8);
  EXPECT_EQ(predictedLevel(levels, 10.0, 10.0 / 1.1), 1);
  EXPECT_EQ(predictedLevel(levels, 10.0, 10.0 / 1.3), 2);
  EXPECT_EQ(predictedLevel(levels, 10.0, 11.0), 0);
  EXPECT_EQ(predictedLevel(levels, 10.0, 0.1), 7);
  EXPECT_EQ(predictedLevel(levels, 10.0, 0.0), 7);
}

}  // namespace
}  // namespace glide
