#include "ar/surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace glide {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

CameraModel phone() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = intrinsics.fy = 500.0;
  intrinsics.cx = 320.0;
  intrinsics.cy = 240.0;
  return CameraModel::create(intrinsics).value();
}

/// Landmarks on the floor y = 1.5 (OpenCV axes) in front of a camera that looks down on it.
MapView floorMap() {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> across(-2.0, 2.0);
  std::uniform_real_distribution<double> along(1.0, 5.0);
  MapView map;
  for (std::uint64_t id = 0; id < 400; ++id)
    map.landmarks.push_back({id, {across(random), 1.5, along(random)}, 3});
  return map;
}

SE3d lookingDown() {
  return {so3Exp(Vec3d(0.6, 0.0, 0.0)), Vec3d::Zero()};  // T_cam_world: 34 degrees below level
}

TEST(VisiblePoints, AreThoseInFrontThatProjectIntoTheImage) {
  MapView map;
  map.landmarks = {{1, {0.0, 0.0, 2.0}, 3}, {2, {0.0, 0.0, -2.0}, 3}, {3, {9.0, 0.0, 2.0}, 3}};
  const std::vector<VisiblePoint> visible = visiblePoints(map, phone(), SE3d{});
  ASSERT_THAT(visible, SizeIs(1));
  EXPECT_EQ(visible[0].index, 0U);
}

TEST(HitTest, FindsTheFloorAndStandsUpOnIt) {
  const SE3d T_cam_world = lookingDown();
  const std::vector<VisiblePoint> visible = visiblePoints(floorMap(), phone(), T_cam_world);
  const std::vector<SurfaceHit> hits = hitTest(visible, phone(), {320.0, 240.0});
  ASSERT_FALSE(hits.empty());
  const auto plane =
      std::find_if(hits.begin(), hits.end(), [](const SurfaceHit& hit) { return hit.points > 1; });
  ASSERT_NE(plane, hits.end());
  const SE3d T_world_hit = T_cam_world.inverse() * plane->T_cam_hit;
  EXPECT_NEAR(T_world_hit.t.y(), 1.5, 1e-6);
  EXPECT_TRUE((T_world_hit.q * Vec3d(0.0, -1.0, 0.0)).isApprox(Vec3d(0.0, -1.0, 0.0), 1e-6));
  EXPECT_NEAR(plane->distance, plane->T_cam_hit.t.norm(), 1e-9);
  EXPECT_TRUE(plane->T_cam_hit.t.isApprox(Vec3d(0.0, 0.0, plane->distance), 1e-9));
}

TEST(HitTest, GivesTheLandmarkUnderThePixelWhereThereIsNoPlane) {
  MapView map;
  map.landmarks = {{1, {0.01, 0.0, 2.0}, 3}};
  const std::vector<SurfaceHit> hits =
      hitTest(visiblePoints(map, phone(), SE3d{}), phone(), {320.0, 240.0});
  ASSERT_THAT(hits, SizeIs(1));
  EXPECT_EQ(hits[0].points, 1);
  EXPECT_TRUE(hits[0].T_cam_hit.t.isApprox(Vec3d(0.01, 0.0, 2.0)));
}

TEST(HitTest, GivesNothingFarFromLandmarks) {
  MapView map;
  map.landmarks = {{1, {0.8, 0.0, 2.0}, 3}};
  EXPECT_THAT(hitTest(visiblePoints(map, phone(), SE3d{}), phone(), {100.0, 240.0}), IsEmpty());
}

TEST(HitTest, TakesNoPlaneThroughACloudOfPoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> side(-0.2, 0.2);
  MapView map;
  for (std::uint64_t id = 0; id < 100; ++id)
    map.landmarks.push_back({id, {side(random), side(random), 2.0 + side(random)}, 3});
  for (const SurfaceHit& hit :
       hitTest(visiblePoints(map, phone(), SE3d{}), phone(), {320.0, 240.0}))
    EXPECT_EQ(hit.points, 1);
}

}  // namespace
}  // namespace glide
