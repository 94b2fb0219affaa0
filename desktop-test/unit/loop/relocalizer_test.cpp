#include "loop/relocalizer.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace glide {
namespace {

using test::DriftedMap;
using test::lookAlong;
using test::SyntheticCloud;
using test::SyntheticCloudOptions;

constexpr double kDegree = 0.0174533;
constexpr int kKeyframes = 16;
// A metre-sized world: 5 cm and 2 degrees are the most that a found pose may be off.
constexpr double kMaxDistance = 0.05, kMaxAngle = 2.0 * kDegree;

CameraModel lens() { return test::syntheticCamera(DistortionModel::radial_tangential); }

/// Several metres of corners in front of a camera that walks along them.
SyntheticCloudOptions wall() {
  SyntheticCloudOptions options;
  options.points = 2500;
  options.low = Vec3d(-4.0, -2.5, 3.0);
  options.high = Vec3d(10.0, 2.5, 5.0);
  options.noise_px = 0.7;
  options.flipped_bits = 20;
  return options;
}

SE3d alongWall(double x) { return lookAlong(Vec3d(x, 0.0, 0.0), 0.0); }

/// kKeyframes, 0.4 m apart.
std::vector<SE3d> walkAlongWall() {
  std::vector<SE3d> path;
  for (int k = 0; k < kKeyframes; ++k) path.push_back(alongWall(0.4 * k));
  return path;
}

/// The map of a path along a wall.
struct MappedWall {
  explicit MappedWall(const SyntheticCloudOptions& options)
      : MappedWall(options, walkAlongWall(), test::Drift::Zero()) {}
  MappedWall(const SyntheticCloudOptions& options,
             const std::vector<SE3d>& path,
             const test::Drift& drift)
      : cloud(lens(), options), map(options, lens(), drift) {
    for (const SE3d& T_cam_world : path) map.add(T_cam_world);
  }

  std::optional<Relocalization> find(const FeatureSet& features) const {
    const RelocalizationQuery query{17, std::make_shared<FeatureSet>(features)};
    return Relocalizer(Config{}, lens()).relocalize(query, *map.snapshot(), map.index());
  }
  std::optional<Relocalization> find(const SE3d& T_cam_world) {
    return find(*cloud.look(T_cam_world).features);
  }
  SE3d poseOf(const Relocalization& found) const {
    return found.T_cam_key * *map.snapshot()->T_cam_world(found.keyframe);
  }

  SyntheticCloud cloud;  ///< for lost frames
  DriftedMap map;
};

/// Features inside of a window of the image.
FeatureSet cropped(const FeatureSet& all, float width, float height) {
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2f& uv = all.feature(i).uv;
    if (uv.x() > width || uv.y() > height) continue;
    features.push_back(all.feature(i));
    descriptors.push_back(all.descriptor(i));
  }
  return {std::move(features), std::move(descriptors), 640, 480};
}

TEST(Relocalizer, FindsFramesBetweenKeyframes) {
  MappedWall wall_map(wall());
  for (int i = 0; i < 10; ++i) {
    SE3d T_cam_world = lookAlong(Vec3d(0.3 + 0.5 * i, 0.2, -0.4 + 0.1 * i), 0.03 * i - 0.15);
    const auto found = wall_map.find(T_cam_world);
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->t_ns, 17);
    EXPECT_LT(test::translationError(wall_map.poseOf(*found), T_cam_world), kMaxDistance) << i;
    EXPECT_LT(test::rotationError(wall_map.poseOf(*found), T_cam_world), kMaxAngle) << i;
    EXPECT_GE(found->inliers, 40);
  }
}

TEST(Relocalizer, FindsACameraThatIsRolled) {
  MappedWall wall_map(wall());
  SE3d T_cam_world = alongWall(2.1);
  const SE3d T_rolled_cam{so3Exp(Vec3d(0.0, 0.0, 40.0 * kDegree)), Vec3d::Zero()};
  T_cam_world = T_rolled_cam * T_cam_world;
  const auto found = wall_map.find(T_cam_world);
  ASSERT_TRUE(found);
  EXPECT_LT(test::rotationError(wall_map.poseOf(*found), T_cam_world), kMaxAngle);
}

TEST(Relocalizer, RefusesAForeignPlace) {
  MappedWall wall_map(wall());
  SyntheticCloudOptions foreign = wall();
  foreign.seed = 99;
  SyntheticCloud elsewhere(lens(), foreign);
  for (int i = 0; i < 5; ++i)
    EXPECT_FALSE(wall_map.find(*elsewhere.look(alongWall(i)).features)) << i;
}

TEST(Relocalizer, RefusesCornersThatAllLookAlike) {
  SyntheticCloudOptions alike = wall();
  alike.looks = 25;
  MappedWall wall_map(alike);
  for (int i = 0; i < 5; ++i) {
    const SE3d T_cam_world = alongWall(0.2 + i);
    const auto found = wall_map.find(T_cam_world);
    if (!found) continue;  // nothing is what we expect, but the truth would do
    EXPECT_LT(test::translationError(wall_map.poseOf(*found), T_cam_world), kMaxDistance) << i;
  }
}

/// A camera that looks at the wall, turns around once and looks at the wall again, which it does
/// not recognise. With each keyframe the map sinks by `drift_y`.
MappedWall seenTwice(double drift_y) {
  std::vector<SE3d> path;
  for (int k = 0; k < 8; ++k) path.push_back(alongWall(0.05 * k));
  for (int k = 1; k < 7; ++k) path.push_back(lookAlong(Vec3d::Zero(), 0.9 * k));
  for (int k = 0; k < 8; ++k) path.push_back(alongWall(0.05 * k));
  test::Drift drift = test::Drift::Zero();
  drift.y() = drift_y;
  return {wall(), path, drift};
}

TEST(Relocalizer, RefusesAPlaceThatTheMapHasTwice) {
  MappedWall once = seenTwice(0.0);
  MappedWall twice = seenTwice(0.1);
  const SE3d T_cam_world = alongWall(0.22);
  EXPECT_TRUE(once.find(T_cam_world));
  EXPECT_FALSE(twice.find(T_cam_world));
}

TEST(Relocalizer, RefusesWhatFillsACornerOfTheImage) {
  SyntheticCloudOptions dense = wall();
  dense.points = 6000;
  dense.missed_share = 0.0;
  MappedWall wall_map(dense);
  const FeatureSet all = *wall_map.cloud.look(alongWall(2.1)).features;
  const FeatureSet corner = cropped(all, 200.0F, 200.0F);
  ASSERT_GT(corner.size(), 80U);
  EXPECT_TRUE(wall_map.find(all));
  EXPECT_FALSE(wall_map.find(corner));
}

TEST(Relocalizer, RefusesTooFewFeatures) {
  MappedWall wall_map(wall());
  const FeatureSet all = *wall_map.cloud.look(alongWall(2.1)).features;
  EXPECT_FALSE(wall_map.find(cropped(all, 640.0F, 40.0F)));
  EXPECT_FALSE(wall_map.find(FeatureSet()));
}

TEST(Relocalizer, FindsNothingInAnEmptyMap) {
  SyntheticCloud cloud(lens(), wall());
  const RelocalizationQuery query{1, cloud.look(alongWall(0.0)).features};
  const Relocalizer relocalizer(Config{}, lens());
  EXPECT_FALSE(relocalizer.relocalize(query, MapSnapshot(), PlaceIndex()));
  MappedWall wall_map(wall());  // an index that is ahead of the map
  EXPECT_FALSE(relocalizer.relocalize(query, MapSnapshot(), wall_map.map.index()));
}

TEST(Relocalizer, GivesTheScaleOfTheKeyframe) {
  MappedWall wall_map(wall());
  const Sim3d growth{Eigen::Quaterniond::Identity(), Vec3d::Zero(), 1.0};
  Sim3d doubled = growth;
  doubled.s = 2.0;
  Map* map = wall_map.map.map();
  for (int k = 0; k < kKeyframes; ++k)
    map->moveKeyframe({KeyframeId{static_cast<std::uint64_t>(k)}, doubled});
  for (const LandmarkId id : map->landmarkIds())
    map->setPosition(id, doubled * map->landmark(id)->p_world);
  for (const LandmarkId id : map->landmarkIds()) map->refreshGeometry(id);
  const auto found = wall_map.find(alongWall(2.1));
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->key_scale, 2.0);
}

TEST(Relocalizer, AnswersTheSameToTheSameQuestion) {
  MappedWall a(wall()), b(wall());
  const FeatureSet features = *a.cloud.look(alongWall(1.3)).features;
  const auto found_a = a.find(features), found_b = b.find(features);
  ASSERT_TRUE(found_a && found_b);
  EXPECT_EQ(found_a->keyframe, found_b->keyframe);
  EXPECT_EQ(found_a->inliers, found_b->inliers);
  EXPECT_EQ(found_a->T_cam_key.t, found_b->T_cam_key.t);
  EXPECT_EQ(found_a->T_cam_key.q.coeffs(), found_b->T_cam_key.q.coeffs());
}

}  // namespace
}  // namespace glide
