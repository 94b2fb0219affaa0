#include "replay/render/ar_scene.h"

#include "geometry/pose_conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace glide::replay {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

CameraModel camera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = intrinsics.fy = 500.0;
  intrinsics.cx = 319.5;
  intrinsics.cy = 239.5;
  return CameraModel::create(intrinsics).value();
}

/// Landmarks 2 m before the first camera, on a plane through (0, 1.5, 2) with this normal.
MapView planeMap(const Vec3d& normal) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> around(-2.0, 2.0);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(-Vec3d::UnitY(), normal);
  MapView map;
  map.generation = 1;
  map.revision = 1;
  MapView::Keyframe keyframe;
  keyframe.id = 1;
  map.keyframes.push_back(keyframe);
  for (std::uint64_t id = 0; id < 900; ++id) {
    const Vec3d p = Vec3d(0.0, 1.5, 2.5) + turn * Vec3d(around(random), 0.0, around(random));
    map.landmarks.push_back({id, {p.x(), p.y(), p.z()}, 3});
  }
  return map;
}

/// A keyframe of a camera that looks 34 degrees down.
FrameResult keyframe() {
  FrameResult frame;
  frame.state = TrackingState::tracking;
  frame.stats.keyframe = true;
  frame.T_world_cam = toPose({so3Exp(Vec3d(-0.6, 0.0, 0.0)), Vec3d::Zero()});
  return frame;
}

TEST(ArScene, SetsCubesDownOnTheFloorApartFromEachOther) {
  const MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  for (int i = 0; i < 3; ++i) scene.show(keyframe(), map);
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
  scene.show(keyframe(), planeMap(-Vec3d::UnitZ()));
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

TEST(ArScene, PlacesNothingWhileTheCameraIsLostOrBetweenKeyframes) {
  const MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  FrameResult frame = keyframe();
  frame.state = TrackingState::lost;
  scene.show(frame, map);
  frame = keyframe();
  frame.stats.keyframe = false;
  scene.show(frame, map);
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

TEST(ArScene, FollowsItsKeyframeWhenTheMapIsCorrectedAndEndsWithTheMap) {
  MapView map = planeMap(-Vec3d::UnitY());
  ArScene scene(camera());
  scene.show(keyframe(), map);
  const Pose before = scene.cubes().at(0);
  map.keyframes[0].T_world_cam.t_xyz = {0.5, 0.0, 0.0};
  ++map.revision;
  FrameResult between = keyframe();
  between.stats.keyframe = false;
  scene.show(between, map);
  EXPECT_NEAR(scene.cubes().at(0).t_xyz[0], before.t_xyz[0] + 0.5, 1e-9);
  ++map.generation;
  scene.show(between, map);
  EXPECT_THAT(scene.cubes(), IsEmpty());
}

}  // namespace
}  // namespace glide::replay
