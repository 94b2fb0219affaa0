#include "replay/render/ar_scene.h"

#include "replay/render/plane_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

CameraModel camera() { return CameraModel::create(planeCamera()).value(); }

TEST(ArScene, SetsCubesDownOnTheFloorApartFromEachOther) {
  const MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  for (int i = 0; i < 3; ++i) scene.show(planeKeyframe(), map);
  const std::vector<Pose> cubes = scene.cubes();
  ASSERT_THAT(cubes, SizeIs(3));
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    EXPECT_NEAR(cubes[i].t_xyz[1], 1.5, 1e-6);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT((fromPose(cubes[i]).t - fromPose(cubes[k]).t).norm(), 2.0 * scene.edge());
  }
}

TEST(ArScene, LeavesWallsEmpty) {
  ArScene scene(camera());
  scene.show(planeKeyframe(), planeMap(-Vec3d::UnitZ()));
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

TEST(ArScene, PlacesNothingWhileTheCameraIsLostOrBetweenKeyframes) {
  const MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  FrameResult frame = planeKeyframe();
  frame.state = TrackingState::lost;
  scene.show(frame, map);
  frame = planeKeyframe();
  frame.stats.keyframe = false;
  scene.show(frame, map);
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

TEST(ArScene, FollowsItsKeyframeWhenTheMapIsCorrectedAndEndsWithTheMap) {
  MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  scene.show(planeKeyframe(), map);
  const Pose before = scene.cubes().at(0);
  map.keyframes[0].T_world_cam.t_xyz = {0.5, 0.0, 0.0};
  ++map.revision;
  FrameResult between = planeKeyframe();
  between.stats.keyframe = false;
  scene.show(between, map);
  EXPECT_NEAR(scene.cubes().at(0).t_xyz[0], before.t_xyz[0] + 0.5, 1e-9);
  ++map.generation;
  scene.show(between, map);
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

TEST(ArScene, SetsCubesDownInTheNextMapHoweverManyTheLastOneHad) {
  MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  for (int i = 0; i < 20; ++i) scene.show(planeKeyframe(), map);
  const std::vector<Pose> before = scene.cubes();
  EXPECT_THAT(before, SizeIs(6));
  ++map.generation;
  scene.show(planeKeyframe(), map);
  ASSERT_THAT(scene.cubes(), SizeIs(1));
  EXPECT_EQ(scene.cubes()[0].t_xyz, before[0].t_xyz);
}

}  // namespace
}  // namespace glide::replay
