#include "render/scene_bounds.h"

#include <gtest/gtest.h>

#include <vector>

namespace glide::test {
namespace {

/// Landmarks from 0 to 1 along all axes, and one far away.
std::vector<LandmarkRecord> diagonal() {
  std::vector<LandmarkRecord> landmarks;
  for (int i = 0; i <= 100; ++i) {
    const float at = 0.01F * static_cast<float>(i);
    landmarks.push_back({{at, at, at}, 3.0F});
  }
  landmarks.push_back({{500.0F, -500.0F, 500.0F}, 2.0F});
  return landmarks;
}

TEST(SceneBounds, LeaveOutliersAside) {
  const SceneBounds bounds = boundsOf(diagonal(), {});
  EXPECT_NEAR(bounds.center[0], 0.5F, 0.05F);
  EXPECT_NEAR(bounds.center[2], 0.5F, 0.05F);
  EXPECT_NEAR(bounds.radius, 0.78F, 0.05F);
  EXPECT_NEAR(bounds.landmarks_low[0], 0.05F, 0.02F);
  EXPECT_NEAR(bounds.landmarks_high[0], 0.95F, 0.02F);
}

TEST(SceneBounds, MeasureHeightsUpwards) {
  const SceneBounds bounds = boundsOf(diagonal(), {});
  EXPECT_NEAR(bounds.low, -0.95F, 0.03F);
  EXPECT_NEAR(bounds.high, -0.05F, 0.03F);
}

TEST(SceneBounds, HoldEveryCamera) {
  const std::vector<PoseRecord> cameras{{{9.0F, 0.5F, 0.5F}, {}, {}}};
  const SceneBounds bounds = boundsOf(diagonal(), cameras);
  EXPECT_GT(bounds.center[0] + bounds.radius, 9.0F);
}

TEST(SceneBounds, AreUsableWithoutLandmarksAndWithOneThing) {
  EXPECT_GT(boundsOf({}, {}).radius, 0.0F);
  const std::vector<PoseRecord> camera{{{1.0F, 2.0F, 3.0F}, {}, {}}};
  const SceneBounds bounds = boundsOf({}, camera);
  EXPECT_EQ(bounds.center[1], 2.0F);
  EXPECT_GT(bounds.radius, 0.0F);
  EXPECT_LT(bounds.low, bounds.high);
}

}  // namespace
}  // namespace glide::test
