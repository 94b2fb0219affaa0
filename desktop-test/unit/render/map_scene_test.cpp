#include "render/map_scene.h"

#include "support/room_map.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

void markAllUploaded(MapScene* scene) {
  scene->landmarks().markUploaded();
  scene->keyframes().markUploaded();
  scene->frames().markUploaded();
  scene->covisibility().markUploaded();
  scene->loops().markUploaded();
  scene->truth().markUploaded();
}

class MapSceneTest : public testing::Test {
 protected:
  MapSceneTest() {
    scene.setMap(room.map);
    for (const FrameResult& frame : room.frames) scene.addFrame(frame);
    scene.setTruth(room.truth);
  }

  RoomMap room = makeRoomMap({});
  MapScene scene;
};

TEST_F(MapSceneTest, HoldsWhatTheMapHolds) {
  EXPECT_EQ(scene.landmarks().size(), room.map->landmarks.size());
  EXPECT_EQ(scene.keyframes().size(), room.map->keyframes.size());
  EXPECT_EQ(scene.frames().size(), room.frames.size());
  EXPECT_EQ(scene.loops().size(), 2U);
  EXPECT_EQ(scene.truth().size(), room.truth.size());
  const LandmarkRecord& record = scene.landmarks().items()[5];
  EXPECT_EQ(record.p_world[2], static_cast<float>(room.map->landmarks[5].p_world[2]));
  EXPECT_EQ(record.observations, static_cast<float>(room.map->landmarks[5].observations));
  EXPECT_EQ(scene.keyframes().items()[3].color, packColor(kIndirectColor));
  EXPECT_EQ(scene.truth().items()[0].color, packColor(kTruthColor));
}

TEST_F(MapSceneTest, DrawsNoFrustumForAKeyframeThatWasRetired) {
  MapView map = *room.map;
  map.keyframes[4].retired = true;
  scene.setMap(std::make_shared<MapView>(map));
  EXPECT_EQ(scene.keyframes().size(), room.map->keyframes.size() - 1);
}

TEST_F(MapSceneTest, UploadsNothingForTheSameMap) {
  markAllUploaded(&scene);
  scene.setMap(room.map);
  EXPECT_FALSE(scene.isChanged());
  scene.setMap(std::make_shared<MapView>(*room.map));
  EXPECT_FALSE(scene.isChanged());
}

TEST_F(MapSceneTest, UploadsOneRecordForAFrame) {
  markAllUploaded(&scene);
  scene.addFrame(room.frames.back());
  EXPECT_EQ(scene.frames().changedFrom() + 1, scene.frames().size());
  EXPECT_FALSE(scene.landmarks().isChanged());
  EXPECT_FALSE(scene.keyframes().isChanged());
}

TEST_F(MapSceneTest, MovesTheWayWithAMapThatWasCorrected) {
  MapView map = *room.map;
  for (MapView::Keyframe& keyframe : map.keyframes) keyframe.T_world_cam.t_xyz[1] -= 1.0;
  const PoseRecord before = scene.frames().items().back();
  scene.setMap(std::make_shared<MapView>(map));
  const PoseRecord after = scene.frames().items().back();
  EXPECT_NEAR(after.p_world[1], before.p_world[1] - 1.0F, 1e-5F);
  EXPECT_NEAR(after.p_world[0], before.p_world[0], 1e-5F);
}

TEST_F(MapSceneTest, ForgetsTheFramesOfAMapThatWasReplaced) {
  auto other = std::make_shared<MapView>();
  other->generation = room.map->generation + 1;
  scene.setMap(other);
  EXPECT_EQ(scene.frames().size(), 0U);
  EXPECT_EQ(scene.landmarks().size(), 0U);
  EXPECT_EQ(scene.truth().size(), room.truth.size());
}

TEST_F(MapSceneTest, MakesNewEdgesForAnotherNumberOfNeighbors) {
  const std::size_t before = scene.covisibility().size();
  MapStyle style;
  style.covisible_neighbors = 1;
  scene.setStyle(style);
  EXPECT_LT(scene.covisibility().size(), before);
  EXPECT_GT(scene.covisibility().size(), 0U);
}

TEST_F(MapSceneTest, IsAllNewAfterALoss) {
  markAllUploaded(&scene);
  scene.markLost();
  EXPECT_EQ(scene.landmarks().changedFrom(), 0U);
  EXPECT_EQ(scene.frames().changedFrom(), 0U);
  EXPECT_TRUE(scene.truth().isChanged());
}

TEST(PackColor, RoundsAndStaysInRange) {
  EXPECT_EQ(packColor({0.0F, 0.5F, 1.0F, 2.0F}), (PackedColor{0, 128, 255, 255}));
  EXPECT_EQ(packColor({-1.0F, 0.0F, 0.0F, 0.25F}), (PackedColor{0, 0, 0, 64}));
}

}  // namespace
}  // namespace glide::test
