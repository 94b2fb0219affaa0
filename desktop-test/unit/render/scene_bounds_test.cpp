#include "render/scene_bounds.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
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
  EXPECT_NEAR(bounds.heights.front(), -0.95F, 0.03F);
  EXPECT_NEAR(bounds.heights.back(), -0.05F, 0.03F);
}

TEST(SceneBounds, PartHeightsIntoEqualShares) {
  std::vector<LandmarkRecord> landmarks;
  for (int i = 0; i < 1000; ++i) {
    const float share = static_cast<float>(i) / 999.0F;
    landmarks.push_back({{0.0F, -share * share * share, 0.0F}, 3.0F});  // most are near the floor
  }
  const SceneBounds bounds = boundsOf(landmarks, {});
  const std::array<float, kHeightSteps + 1> shares{0.05F, 0.275F, 0.5F, 0.725F, 0.95F};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    EXPECT_NEAR(bounds.heights[i], shares[i] * shares[i] * shares[i], 0.01F);
  }
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
}

}  // namespace
}  // namespace glide::test
