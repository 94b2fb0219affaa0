#include "mapping/insertion.h"

#include "support/mapped_scene.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::SyntheticTracker;
using test::walk;

class InsertionTest : public testing::Test {
 protected:
  InsertionTest() : scene_(smallCloud(), {}) { scene_.start(); }

  NewKeyframe nextKeyframe() {
    return scene_.tracker.track(*scene_.map(), scene_.cloud.look(walk(2)), scene_.newest());
  }
  Map& map() { return scene_.state.map; }

  MappedScene scene_;
};

TEST_F(InsertionTest, PlacesTheKeyframeWhereItWasTracked) {
  const NewKeyframe message = nextKeyframe();
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_LT(scene_.keyframeError(), 1e-4);
  EXPECT_GT(map().covisibility().weight(message.reference, message.id), 50);
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(InsertionTest, FollowsAReferenceWhoseUnitGrewSinceTheFrameWasTracked) {
  const NewKeyframe message = nextKeyframe();
  constexpr double kGrowth = 1.5;
  const Sim3d S_new_old{so3Exp(Vec3d(0.0, 0.2, 0.0)), Vec3d(0.3, 0.0, 0.1), kGrowth};
  std::vector<KeyframeId> ids;
  for (const auto& [id, keyframe] : map().keyframes()) ids.push_back(id);
  for (const KeyframeId id : ids) map().moveKeyframe({id, S_new_old});
  for (const LandmarkId id : map().landmarkIds())
    map().setPosition(id, S_new_old * map().landmark(id)->p_world);
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_LT(scene_.keyframeError(), 1e-4);
  EXPECT_NEAR(*map().scale(message.id), kGrowth, 1e-12);
}

TEST_F(InsertionTest, FollowsAReferenceThatMovedSinceTheFrameWasTracked) {
  const NewKeyframe message = nextKeyframe();
  const SE3d T_new_old{so3Exp(Vec3d(0.0, 0.3, 0.0)),
                       Vec3d(0.5, 0.0, 0.0)};  // as a loop closure does
  for (const auto& [id, keyframe] : map().keyframes()) {
    map().setPose(id, keyframe.T_cam_world * T_new_old.inverse());
  }
  for (const LandmarkId id : map().landmarkIds()) {
    map().setPosition(id, T_new_old * map().landmark(id)->p_world);
  }
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_LT(scene_.keyframeError(), 1e-4);
}

TEST_F(InsertionTest, FollowsAReferenceThatWasRetired) {
  scene_.insert(walk(2));
  NewKeyframe message =
      scene_.tracker.track(*scene_.map(), scene_.cloud.look(walk(3)), KeyframeId{1});
  map().retireKeyframe(KeyframeId{1});
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_LT(scene_.keyframeError(), 1e-4);
}

TEST_F(InsertionTest, IgnoresLandmarksThatAreGone) {
  NewKeyframe message = nextKeyframe();
  int kept = 0;
  for (const LandmarkId id : message.landmarks) {
    if (id == kNoLandmark) continue;
    if (++kept % 2 == 0) map().removeLandmark(id);
  }
  message.landmarks[0] = LandmarkId{123456789};
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(InsertionTest, CountsALandmarkOncePerKeyframe) {
  NewKeyframe message = nextKeyframe();
  LandmarkId repeated = kNoLandmark;
  for (LandmarkId& id : message.landmarks) {
    if (id != kNoLandmark && repeated == kNoLandmark) repeated = id;
    if (id == kNoLandmark && repeated != kNoLandmark) id = repeated;
  }
  ASSERT_TRUE(insertKeyframe(&scene_.state, message));
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(InsertionTest, LeavesMismatchesOut) {
  SyntheticTracker::Options options;
  options.mismatch_share = 0.2;
  options.pose_noise = 0.01;
  MappedScene scene(smallCloud(), options);
  scene.start();
  const KeyframeId id = scene.insert(walk(2));
  EXPECT_LT(scene.keyframeError(), 1e-3);
  const auto snapshot = scene.map();
  const MapSnapshot::KeyframeEntry& keyframe = *snapshot->keyframe(id);
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    const auto* landmark = snapshot->landmark(keyframe.landmarks[i]);
    if (landmark == nullptr) continue;
    const auto uv = scene.cloud.camera().project(keyframe.T_cam_world * landmark->p_world);
    const Feature& feature = keyframe.features->feature(i);
    const double error_px = (*uv - feature.uv.cast<double>()).norm();
    EXPECT_LT(error_px, 2.5 * scene.state.map.levels().scale(feature.level));
  }
}

TEST_F(InsertionTest, RetiresABlankKeyframeAtOnceSoThatItsPoseStaysDefined) {
  NewKeyframe message = nextKeyframe();
  message.features = std::make_shared<FeatureSet>();
  message.landmarks.clear();
  EXPECT_FALSE(insertKeyframe(&scene_.state, message));
  EXPECT_EQ(map().keyframe(message.id), nullptr);
  const auto T_cam_world = map().T_cam_world(message.id);
  ASSERT_TRUE(T_cam_world.has_value());
  const SE3d T_expected = message.T_cam_ref * *map().T_cam_world(message.reference);
  EXPECT_LT(test::translationError(*T_cam_world, T_expected), 1e-9);
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(InsertionTest, RefusesAReferenceItDoesNotKnow) {
  NewKeyframe message = nextKeyframe();
  message.reference = KeyframeId{77};
  EXPECT_FALSE(insertKeyframe(&scene_.state, message));
  EXPECT_EQ(map().keyframes().size(), 2U);
  EXPECT_TRUE(map().retired().empty());
}

TEST_F(InsertionTest, RefusesAnIdThatIsNotNew) {
  NewKeyframe message = nextKeyframe();
  message.id = KeyframeId{1};
  EXPECT_FALSE(insertKeyframe(&scene_.state, message));
  EXPECT_EQ(map().keyframes().size(), 2U);
}

}  // namespace
}  // namespace glide
