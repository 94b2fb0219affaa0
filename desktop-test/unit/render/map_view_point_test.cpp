#include "render/map_view_point.h"

#include "support/room_map.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace glide::test {
namespace {

MapScene roomScene() {
  const RoomMap room = makeRoomMap({});
  MapScene scene;
  scene.setMap(room.map);
  for (const FrameResult& frame : room.frames) scene.addFrame(frame);
  return scene;
}

glm::vec4 project(const MapViewPoint& view, const glm::vec3& p_world) {
  return view.clip_from_eye * view.eye_from_world * glm::vec4(p_world, 1.0F);
}

TEST(Plan, ShowsEveryKeyframeWhateverTheViewportsShape) {
  const MapScene scene = roomScene();
  for (const Viewport& viewport :
       {Viewport{0, 0, 200, 200}, Viewport{0, 0, 400, 60}, Viewport{0, 0, 50, 300}}) {
    const MapViewPoint view = viewFromAbove(groundOf(scene), viewport);
    for (const PoseRecord& camera : scene.keyframes().items()) {
      const auto& p = camera.p_world;
      const glm::vec4 clip = project(view, {p[0], p[1], p[2]});
      EXPECT_LT(std::abs(clip.x), 1.0F);
      EXPECT_LT(std::abs(clip.y), 1.0F);
      EXPECT_LT(std::abs(clip.z), 1.0F);
    }
  }
}

TEST(Plan, HasTheWorldsZUpAndXToTheRightWithoutStretching) {
  const MapViewPoint view = viewFromAbove(groundOf(roomScene()), {0, 0, 320, 160});
  const glm::vec4 origin = project(view, {0.0F, 0.0F, 0.0F});
  const glm::vec4 right = project(view, {0.1F, 0.0F, 0.0F}) - origin;
  const glm::vec4 forward = project(view, {0.0F, 0.0F, 0.1F}) - origin;
  const glm::vec4 down = project(view, {0.0F, 0.1F, 0.0F}) - origin;
  EXPECT_GT(right.x, 0.0F);
  EXPECT_NEAR(right.y, 0.0F, 1e-6F);
  EXPECT_GT(forward.y, 0.0F);
  EXPECT_NEAR(forward.x, 0.0F, 1e-6F);
  EXPECT_NEAR(320.0F * right.x, 160.0F * forward.y, 1e-3F);
  EXPECT_GT(down.z, 0.0F);  // what is lower is farther
  EXPECT_NEAR(0.1F / (0.5F * 320.0F * right.x), unitsPerPixel(view), 1e-6F);
}

TEST(Plan, ReachesForLandmarksAroundTheCamerasButNotForThoseFarAway) {
  MapScene near;
  MapView map;
  map.keyframes.emplace_back();
  map.keyframes.emplace_back();
  map.keyframes[1].id = 1;
  map.keyframes[1].T_world_cam.t_xyz = {1.0, 0.0, 0.0};
  for (std::uint64_t i = 0; i < 20; ++i) map.landmarks.push_back({i, {0.5, 0.0, 1.0}, 3});
  near.setMap(std::make_shared<MapView>(map));
  EXPECT_FLOAT_EQ(groundOf(near).high.y, 1.0F);
  for (MapView::Landmark& landmark : map.landmarks) landmark.p_world[2] = 100.0;
  MapScene far;
  far.setMap(std::make_shared<MapView>(map));
  EXPECT_LT(groundOf(far).high.y, 2.0F);
}

TEST(Plan, IsThereForAnEmptyMap) {
  const MapViewPoint view = viewFromAbove(groundOf(MapScene()), {0, 0, 100, 100});
  EXPECT_TRUE(std::isfinite(project(view, {1.0F, 1.0F, 1.0F}).x));
  EXPECT_GT(unitsPerPixel(view), 0.0F);
}

TEST(DepthCue, BeginsWhereTheSceneDoes) {
  MapViewPoint view;  // at the origin, forward is -z
  SceneBounds bounds;
  bounds.center = {0.0F, 0.0F, -5.0F};
  bounds.radius = 2.0F;
  const glm::vec2 cue = depthCue(view, bounds);
  EXPECT_FLOAT_EQ(cue.x, 3.0F);
  EXPECT_FLOAT_EQ(cue.y, 0.25F);
}

TEST(DepthCue, IsAboutWhatIsInFrontOfAnEyeInTheMiddle) {
  MapViewPoint view;
  SceneBounds bounds;
  bounds.radius = 2.0F;
  const glm::vec2 cue = depthCue(view, bounds);
  EXPECT_FLOAT_EQ(cue.x, 0.0F);
  EXPECT_FLOAT_EQ(cue.y, 0.5F);
}

TEST(ImagePlane, IsTheImagesEdgeAtDistanceOne) {
  const CameraIntrinsics camera{640, 480, 500.0, 400.0, 300.0, 240.0, {}, {}};
  const glm::vec4 plane = imagePlane(camera);
  EXPECT_FLOAT_EQ(plane.x, -300.5F / 500.0F);
  EXPECT_FLOAT_EQ(plane.y, -240.5F / 400.0F);
  EXPECT_FLOAT_EQ(plane.z, 339.5F / 500.0F);
  EXPECT_FLOAT_EQ(plane.w, 239.5F / 400.0F);
}

TEST(ImagePlane, StaysDrawableForAFisheyeAndForNoCamera) {
  const CameraIntrinsics fisheye{640, 480, 100.0, 100.0, 320.0, 240.0, {}, {}};
  EXPECT_FLOAT_EQ(imagePlane(fisheye).z, 1.5F);
  EXPECT_GT(imagePlane({}).z, 0.0F);
}

}  // namespace
}  // namespace glide::test
