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
    scene_.setMap(room_.map);
    for (const FrameResult& frame : room_.frames) scene_.addFrame(frame);
    scene_.setTruth(room_.truth);
  }

  RoomMap room_ = makeRoomMap({});
  MapScene scene_;
};

TEST_F(MapSceneTest, HoldsWhatTheMapHolds) {
  EXPECT_EQ(scene_.landmarks().size(), room_.map->landmarks.size());
  EXPECT_EQ(scene_.keyframes().size(), room_.map->keyframes.size());
  EXPECT_EQ(scene_.frames().size(), room_.frames.size());
  EXPECT_EQ(scene_.loops().size(), 2U);
  EXPECT_EQ(scene_.truth().size(), room_.truth.size());
  const LandmarkRecord& record = scene_.landmarks().items()[5];
  EXPECT_EQ(record.p_world[2], static_cast<float>(room_.map->landmarks[5].p_world[2]));
  EXPECT_EQ(record.observations, static_cast<float>(room_.map->landmarks[5].observations));
  EXPECT_EQ(scene_.keyframes().items()[3].color, packColor(kIndirectColor));
  EXPECT_EQ(scene_.truth().items()[0].color, packColor(kTruthColor));
}

TEST_F(MapSceneTest, DrawsNoFrustumForAKeyframeThatWasRetired) {
  MapView map = *room_.map;
  map.keyframes[4].retired = true;
  scene_.setMap(std::make_shared<MapView>(map));
  EXPECT_EQ(scene_.keyframes().size(), room_.map->keyframes.size() - 1);
}

TEST_F(MapSceneTest, UploadsNothingForTheSameMap) {
  markAllUploaded(&scene_);
  scene_.setMap(room_.map);
  EXPECT_FALSE(scene_.isChanged());
  scene_.setMap(std::make_shared<MapView>(*room_.map));
  EXPECT_FALSE(scene_.isChanged());
}

TEST_F(MapSceneTest, UploadsOneRecordForAFrame) {
  markAllUploaded(&scene_);
  scene_.addFrame(room_.frames.back());
  EXPECT_EQ(scene_.frames().changedFrom() + 1, scene_.frames().size());
  EXPECT_FALSE(scene_.landmarks().isChanged());
  EXPECT_FALSE(scene_.keyframes().isChanged());
}

TEST_F(MapSceneTest, MovesTheWayWithAMapThatWasCorrected) {
  MapView map = *room_.map;
  for (MapView::Keyframe& keyframe : map.keyframes) keyframe.T_world_cam.t_xyz[1] -= 1.0;
  const PoseRecord before = scene_.frames().items().back();
  scene_.setMap(std::make_shared<MapView>(map));
  const PoseRecord after = scene_.frames().items().back();
  EXPECT_NEAR(after.p_world[1], before.p_world[1] - 1.0F, 1e-5F);
  EXPECT_NEAR(after.p_world[0], before.p_world[0], 1e-5F);
}

TEST_F(MapSceneTest, ForgetsTheFramesOfAMapThatWasReplaced) {
  auto other = std::make_shared<MapView>();
  other->generation = room_.map->generation + 1;
  scene_.setMap(other);
  EXPECT_EQ(scene_.frames().size(), 0U);
  EXPECT_EQ(scene_.landmarks().size(), 0U);
  EXPECT_EQ(scene_.truth().size(), room_.truth.size());
}

TEST_F(MapSceneTest, MakesNewEdgesForAnotherNumberOfNeighbors) {
  const std::size_t before = scene_.covisibility().size();
  MapStyle style;
  style.covisible_neighbors = 1;
  scene_.setStyle(style);
  EXPECT_LT(scene_.covisibility().size(), before);
  EXPECT_GT(scene_.covisibility().size(), 0U);
}

TEST_F(MapSceneTest, IsAllNewAfterALoss) {
  markAllUploaded(&scene_);
  scene_.markLost();
  EXPECT_EQ(scene_.landmarks().changedFrom(), 0U);
  EXPECT_EQ(scene_.frames().changedFrom(), 0U);
  EXPECT_TRUE(scene_.truth().isChanged());
}

TEST(PackColor, RoundsAndStaysInRange) {
  EXPECT_EQ(packColor({0.0F, 0.5F, 1.0F, 2.0F}), (PackedColor{0, 128, 255, 255}));
  EXPECT_EQ(packColor({-1.0F, 0.0F, 0.0F, 0.25F}), (PackedColor{0, 0, 0, 64}));
}

}  // namespace
}  // namespace glide::test
