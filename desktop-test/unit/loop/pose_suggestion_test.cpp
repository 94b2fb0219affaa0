#include "loop/pose_suggestion.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include <gtest/gtest.h>

#include <vector>

namespace glide {
namespace {

using test::DriftedMap;
using test::lookAlong;

CameraModel lens() { return test::syntheticCamera(DistortionModel::radial_tangential); }

test::SyntheticCloudOptions wall() {
  test::SyntheticCloudOptions options;
  options.low = Vec3d(-4.0, -2.5, 3.0);
  options.high = Vec3d(6.0, 2.5, 5.0);
  options.flipped_bits = 15;
  return options;
}

PlaceGroup groupOf(const MapSnapshot& map, const std::vector<std::uint64_t>& ids) {
  PlaceGroup group;
  for (const std::uint64_t id : ids) group.keyframes.push_back(map.keyframe(KeyframeId{id}));
  return group;
}

TEST(PoseSuggestion, IsTheTruthWithoutNoise) {
  DriftedMap map(wall(), lens(), test::Drift::Zero());
  for (int k = 0; k < 4; ++k) map.add(lookAlong(Vec3d(0.3 * k, 0.0, 0.0), 0.0));
  const auto snapshot = map.snapshot();
  test::SyntheticCloud cloud(lens(), wall());
  const auto view = cloud.look(lookAlong(Vec3d(0.5, 0.2, 0.1), 0.1));
  const auto suggestions =
      suggestPoses(lens(), *snapshot, groupOf(*snapshot, {1, 2}), *view.features);
  ASSERT_EQ(suggestions.size(), 1U);
  EXPECT_LT(test::translationError(suggestions[0].T_cam_world, view.T_cam_world), 1e-4);
  EXPECT_LT(test::rotationError(suggestions[0].T_cam_world, view.T_cam_world), 1e-4);
  EXPECT_GT(suggestions[0].seen.size(), 100U);
}

TEST(PoseSuggestion, IsMissingForAnotherPlace) {
  DriftedMap map(wall(), lens(), test::Drift::Zero());
  for (int k = 0; k < 4; ++k) map.add(lookAlong(Vec3d(0.3 * k, 0.0, 0.0), 0.0));
  const auto snapshot = map.snapshot();
  test::SyntheticCloudOptions foreign = wall();
  foreign.seed = 7;
  const auto view = test::SyntheticCloud(lens(), foreign).look(SE3d{});
  EXPECT_TRUE(suggestPoses(lens(), *snapshot, groupOf(*snapshot, {1, 2}), *view.features).empty());
  EXPECT_TRUE(suggestPoses(lens(), *snapshot, PlaceGroup{}, *view.features).empty());
}

TEST(PoseSuggestion, ComesInTwoWhereThePlaceFitsTwice) {
  // One look at the wall, then another by a camera whose map has sunk meanwhile.
  test::Drift slip = test::Drift::Zero();
  slip.y() = 0.02;
  DriftedMap map(wall(), lens(), slip);
  for (int k = 0; k < 4; ++k) map.add(lookAlong(Vec3d(0.1 * k, 0.0, 0.0), 0.0));
  for (int k = 1; k < 42; ++k) map.add(lookAlong(Vec3d::Zero(), 0.15 * k));
  for (int k = 0; k < 4; ++k) map.add(lookAlong(Vec3d(0.1 * k, 0.0, 0.0), 0.0));
  const auto snapshot = map.snapshot();
  test::SyntheticCloud cloud(lens(), wall());
  const auto view = cloud.look(lookAlong(Vec3d(0.15, 0.0, 0.0), 0.0));
  const auto suggestions =
      suggestPoses(lens(), *snapshot, groupOf(*snapshot, {2, 47}), *view.features);
  ASSERT_EQ(suggestions.size(), 2U);
  EXPECT_GT(test::translationError(suggestions[0].T_cam_world, suggestions[1].T_cam_world), 0.5);
  EXPECT_GE(suggestions[0].seen.size(), suggestions[1].seen.size());
}

}  // namespace
}  // namespace glide
