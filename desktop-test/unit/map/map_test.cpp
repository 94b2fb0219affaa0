#include "map/map.h"

#include "map/map_consistency.h"
#include "map/snapshot_builder.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace glide {
namespace {

constexpr int kFeatures = 20;

Keyframe keyframeAt(std::uint64_t id, const Vec3d& center_world) {
  std::mt19937_64 random(id);
  std::vector<Feature> features(kFeatures);
  std::vector<Descriptor> descriptors(kFeatures);
  for (Descriptor& descriptor : descriptors) {
    for (std::uint64_t& word : descriptor) word = random();
  }
  Keyframe keyframe;
  keyframe.id = KeyframeId{id};
  keyframe.t_ns = static_cast<std::int64_t>(id) * 1000;
  keyframe.T_cam_world.t = -center_world;
  keyframe.features =
      std::make_shared<FeatureSet>(std::move(features), std::move(descriptors), 640, 480);
  return keyframe;
}

/// Three keyframes in a row; landmark i is feature i of all of them, the second half not of the
/// third.
class MapTest : public testing::Test {
 protected:
  MapTest() {
    for (std::uint64_t k = 0; k < 3; ++k) {
      map_.addKeyframe(keyframeAt(k, Vec3d(static_cast<double>(k), 0.0, 0.0)));
    }
    for (int i = 0; i < kFeatures; ++i) {
      const LandmarkId id = map_.addLandmark(Vec3d(i, 0.0, 5.0), KeyframeId{0});
      ids_.push_back(id);
      map_.addObservation(id, {KeyframeId{0}, i});
      map_.addObservation(id, {KeyframeId{1}, i});
      if (i < kFeatures / 2) map_.addObservation(id, {KeyframeId{2}, i});
    }
    map_.refreshChanged();
  }

  Map map_{ScaleLevels(1.2, 8)};
  std::vector<LandmarkId> ids_;
};

TEST_F(MapTest, KeepsObservationsBothWays) {
  EXPECT_EQ(checkConsistency(map_), "");
  EXPECT_EQ(map_.keyframe(KeyframeId{1})->landmarks[3], ids_[3]);
  EXPECT_EQ(map_.covisibility().weight(KeyframeId{0}, KeyframeId{1}), kFeatures);
  EXPECT_EQ(map_.covisibility().weight(KeyframeId{0}, KeyframeId{2}), kFeatures / 2);
}

TEST_F(MapTest, RefusesImpossibleObservations) {
  const LandmarkId fresh = map_.addLandmark(Vec3d::Zero(), KeyframeId{2});
  EXPECT_FALSE(map_.addObservation(fresh, {KeyframeId{0}, 0}));          // slot is taken
  EXPECT_FALSE(map_.addObservation(fresh, {KeyframeId{2}, kFeatures}));  // no such feature
  EXPECT_FALSE(map_.addObservation(fresh, {KeyframeId{2}, -1}));
  EXPECT_FALSE(map_.addObservation(fresh, {KeyframeId{9}, 0}));
  EXPECT_FALSE(map_.addObservation(LandmarkId{999}, {KeyframeId{2}, 15}));
  EXPECT_FALSE(map_.addObservation(ids_[0], {KeyframeId{2}, 15}));  // sees it already
  map_.removeLandmark(fresh);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, RefusesAKeyframeIdThatIsTaken) {
  EXPECT_FALSE(map_.addKeyframe(keyframeAt(1, Vec3d::Zero())));
  map_.retireKeyframe(KeyframeId{1});
  EXPECT_FALSE(map_.addKeyframe(keyframeAt(1, Vec3d::Zero())));
}

TEST_F(MapTest, DropsALandmarkWithItsSecondLastObservation) {
  map_.removeObservation(ids_[0], KeyframeId{2});
  ASSERT_NE(map_.landmark(ids_[0]), nullptr);
  map_.removeObservation(ids_[0], KeyframeId{0});
  EXPECT_EQ(map_.landmark(ids_[0]), nullptr);
  EXPECT_EQ(map_.keyframe(KeyframeId{1})->landmarks[0], kNoLandmark);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, FusionMovesObservationsAndCounts) {
  const LandmarkId twin = map_.addLandmark(Vec3d::Zero(), KeyframeId{2});
  map_.addKeyframe(keyframeAt(3, Vec3d(3.0, 0.0, 0.0)));
  map_.addObservation(twin, {KeyframeId{2}, 15});
  map_.addObservation(twin, {KeyframeId{3}, 7});
  map_.countSighting({twin, 10, 5});
  map_.replaceLandmark(twin, ids_[2]);
  EXPECT_EQ(map_.landmark(twin), nullptr);
  EXPECT_EQ(map_.landmark(ids_[2])->observations.size(), 4U);
  EXPECT_EQ(map_.landmark(ids_[2])->visible_count, 12);
  EXPECT_EQ(map_.landmark(ids_[2])->found_count, 7);
  EXPECT_EQ(map_.keyframe(KeyframeId{3})->landmarks[7], ids_[2]);
  EXPECT_EQ(map_.keyframe(KeyframeId{2})->landmarks[15], kNoLandmark);  // saw it as feature 2
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, FusionOfALandmarkWithItselfOrTheDeadChangesNothing) {
  map_.replaceLandmark(ids_[0], ids_[0]);
  map_.replaceLandmark(LandmarkId{999}, ids_[0]);
  map_.replaceLandmark(ids_[0], LandmarkId{999});
  EXPECT_EQ(map_.landmarkCount(), static_cast<std::size_t>(kFeatures));
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, RetiredKeyframesFollowTheirBestNeighbor) {
  ASSERT_TRUE(map_.retireKeyframe(KeyframeId{0}));
  EXPECT_EQ(map_.keyframe(KeyframeId{0}), nullptr);
  EXPECT_EQ(map_.retired().at(KeyframeId{0}).parent, KeyframeId{1});
  SE3d T_cam_world = *map_.T_cam_world(KeyframeId{1});
  T_cam_world.t.y() += 0.5;
  map_.setPose(KeyframeId{1}, T_cam_world);
  EXPECT_NEAR((map_.T_cam_world(KeyframeId{0})->t - Vec3d(0.0, 0.5, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, PosesStayDefinedWhenTheParentRetiresToo) {
  map_.retireKeyframe(KeyframeId{0});
  map_.retireKeyframe(KeyframeId{1});
  EXPECT_EQ(map_.retired().at(KeyframeId{0}).parent, KeyframeId{2});
  EXPECT_NEAR(map_.T_cam_world(KeyframeId{0})->t.norm(), 0.0, 1e-12);
  EXPECT_NEAR(map_.T_cam_world(KeyframeId{1})->t.x(), -1.0, 1e-12);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapTest, NeverRetiresTheLastKeyframeOrAnUnknownOne) {
  EXPECT_FALSE(map_.retireKeyframe(KeyframeId{77}));
  map_.retireKeyframe(KeyframeId{0});
  map_.retireKeyframe(KeyframeId{1});
  EXPECT_FALSE(map_.retireKeyframe(KeyframeId{2}));
  EXPECT_FALSE(map_.T_cam_world(KeyframeId{77}).has_value());
}

TEST_F(MapTest, RetiringAnUnconnectedKeyframeUsesTheOneBefore) {
  map_.addKeyframe(keyframeAt(3, Vec3d(3.0, 0.0, 0.0)));
  map_.retireKeyframe(KeyframeId{3});
  EXPECT_EQ(map_.retired().at(KeyframeId{3}).parent, KeyframeId{2});
}

TEST_F(MapTest, IdsOfLandmarksAscendAlsoAcrossClear) {
  map_.clear();
  EXPECT_TRUE(map_.landmarkIds().empty());
  EXPECT_TRUE(map_.keyframes().empty());
  const LandmarkId id = map_.addLandmark(Vec3d::Zero(), KeyframeId{0});
  EXPECT_LT(ids_.back(), id);
}

TEST_F(MapTest, SnapshotCopiesTheMapAndDoesNotFollowIt) {
  map_.retireKeyframe(KeyframeId{0});
  const auto snapshot = snapshotOf(map_, {5, 1, 0, 15});
  map_.setPose(KeyframeId{1}, SE3d{});
  map_.removeLandmark(ids_[3]);
  EXPECT_EQ(snapshot->revision(), 5U);
  ASSERT_EQ(snapshot->keyframes().size(), 2U);
  EXPECT_NEAR(snapshot->keyframe(KeyframeId{1})->T_cam_world.t.x(), -1.0, 1e-12);
  EXPECT_NEAR(snapshot->T_cam_world(KeyframeId{0})->t.norm(), 0.0, 1e-12);
  ASSERT_NE(snapshot->landmark(ids_[3]), nullptr);
  EXPECT_EQ(snapshot->landmark(ids_[3])->observations.size(), 2U);
  EXPECT_EQ(snapshot->landmark(ids_[15]), nullptr);  // was seen by keyframes 0 and 1 only
}

TEST_F(MapTest, RefreshedLandmarksLookFromTheirCameras) {
  const Landmark& landmark =
      *map_.landmark(ids_[1]);  // straight ahead of the middle of three cameras
  EXPECT_NEAR((landmark.normal - Vec3d(0.0, 0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_GE(landmark.max_distance, 5.0);
  EXPECT_NE(landmark.descriptor, Descriptor{});
}

}  // namespace
}  // namespace glide
