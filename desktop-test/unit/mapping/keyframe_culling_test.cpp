#include "mapping/keyframe_culling.h"

#include "support/mapped_scene.h"

#include "mapping/fusion.h"
#include "mapping/new_landmarks.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::MappedScene;
using test::SyntheticCloudOptions;
using test::walk;

/// Everything that is visible is detected, so that dense views see the same.
SyntheticCloudOptions fullyDetected() {
  SyntheticCloudOptions options = test::smallCloud();
  options.missed_share = 0.0;
  return options;
}

void fill(MappedScene* scene, double step_length, int count) {
  scene->start();
  for (int i = 1; i <= count; ++i) {
    const KeyframeId id = scene->insert(walk(1.0 + step_length * i));
    createLandmarks(&scene->state, id, nullptr);
    fuseAround(&scene->state, id, nullptr);
  }
}

TEST(KeyframeCulling, RetiresKeyframesWhoseLandmarksOthersSeeAsWell) {
  MappedScene scene(fullyDetected(), {});
  fill(&scene, 0.1, 8);
  const std::size_t before = scene.state.map.keyframes().size();
  cullRedundantKeyframes(&scene.state, scene.newest());
  EXPECT_LT(scene.state.map.keyframes().size(), before);
  EXPECT_FALSE(scene.state.map.retired().empty());
  EXPECT_EQ(checkConsistency(scene.state.map), "");
}

TEST(KeyframeCulling, NeverTakesTheFirstOrTheNewestTwo) {
  MappedScene scene(fullyDetected(), {});
  fill(&scene, 0.02, 6);
  const KeyframeId newest = scene.newest();
  const KeyframeId second{newest.value - 1};
  for (int i = 0; i < 3; ++i) cullRedundantKeyframes(&scene.state, newest);
  EXPECT_NE(scene.state.map.keyframe(KeyframeId{0}), nullptr);
  EXPECT_NE(scene.state.map.keyframe(newest), nullptr);
  EXPECT_NE(scene.state.map.keyframe(second), nullptr);
  EXPECT_GE(scene.state.map.keyframes().size(), 3U);  // witnesses of those that went
}

TEST(KeyframeCulling, KeepsKeyframesThatSeeSomethingOfTheirOwn) {
  MappedScene scene(fullyDetected(), {});
  fill(&scene, 4.0, 5);  // one unit apart
  const std::size_t before = scene.state.map.keyframes().size();
  cullRedundantKeyframes(&scene.state, scene.newest());
  EXPECT_EQ(scene.state.map.keyframes().size(), before);
}

TEST(KeyframeCulling, KeepsTheTrackOfRetiredPoses) {
  MappedScene scene(fullyDetected(), {});
  fill(&scene, 0.1, 8);
  const auto before = scene.map();
  cullRedundantKeyframes(&scene.state, scene.newest());
  for (const auto& keyframe : before->keyframes()) {
    const auto T_cam_world = scene.state.map.T_cam_world(keyframe.id);
    ASSERT_TRUE(T_cam_world.has_value());
    EXPECT_LT(test::translationError(*T_cam_world, keyframe.T_cam_world), 1e-9);
  }
}

}  // namespace
}  // namespace glide
