#include "track/anchored_pose.h"

#include "map/map.h"
#include "map/snapshot_builder.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

constexpr KeyframeId kFirst{3}, kSecond{4};

class AnchoredPoseTest : public testing::Test {
 protected:
  AnchoredPoseTest() : map_(ScaleLevels(1.2, 8)) {
    for (const KeyframeId id : {kFirst, kSecond}) {
      Keyframe keyframe;
      keyframe.id = id;
      keyframe.features = std::make_shared<const FeatureSet>();
      keyframe.T_cam_world = {so3Exp(Vec3d(0.0, 0.1, 0.0)),
                              Vec3d(0.5, 0.0, static_cast<double>(id.value))};
      map_.addKeyframe(keyframe);
    }
  }

  std::shared_ptr<const MapSnapshot> snapshot() const { return snapshotOf(map_, {1, 1, 0, 1}); }

  Map map_;
  const SE3d T_cam_world_{so3Exp(Vec3d(0.2, 0.0, 0.1)), Vec3d(1.0, -2.0, 0.5)};
};

TEST_F(AnchoredPoseTest, GivesBackThePoseItWasMadeFrom) {
  const AnchoredPose pose = anchorTo(kFirst, T_cam_world_, *snapshot());
  EXPECT_LT((pose.T_cam_world(*snapshot()).t - T_cam_world_.t).norm(), 1e-12);
}

TEST_F(AnchoredPoseTest, SeesTheSameAfterASimilarityOfTheWorld) {
  const AnchoredPose pose = anchorTo(kFirst, T_cam_world_, *snapshot());
  const Sim3d S_new_old{so3Exp(Vec3d(0.3, -0.2, 0.1)), Vec3d(2.0, 1.0, 0.0), 1.7};
  map_.moveKeyframe({kFirst, S_new_old});
  const Vec3d p_world(0.4, 0.3, 5.0);
  const Vec3d before = T_cam_world_ * p_world;
  const Vec3d after = pose.T_cam_world(*snapshot()) * (S_new_old * p_world);
  EXPECT_LT((after - 1.7 * before).norm(), 1e-12);  // the same ray, in the new unit
}

TEST_F(AnchoredPoseTest, FollowsARetiredKeyframeThroughACorrectionOfItsParent) {
  const AnchoredPose pose = anchorTo(kSecond, T_cam_world_, *snapshot());
  ASSERT_TRUE(map_.retireKeyframe(kSecond));
  const Sim3d S_new_old{so3Exp(Vec3d(0.0, 0.5, 0.0)), Vec3d(0.0, 1.0, 0.0), 0.6};
  map_.moveKeyframe({kFirst, S_new_old});
  const Vec3d p_world(-0.4, 0.3, 4.0);
  const Vec3d before = T_cam_world_ * p_world;
  const Vec3d after = pose.T_cam_world(*snapshot()) * (S_new_old * p_world);
  EXPECT_LT((after - 0.6 * before).norm(), 1e-12);
}

TEST_F(AnchoredPoseTest, FollowsACorrectionBeforeItsKeyframeIsPublished) {
  const AnchoredPose measured = anchorTo(kFirst, T_cam_world_, *snapshot());
  const AnchoredPose::Support support{measured.keyframe, measured.T_cam_key, measured.key_scale};
  const SE3d T_later_key{so3Exp(Vec3d(0.0, 0.1, 0.0)), Vec3d(0.1, 0.0, 0.2)};
  const AnchoredPose later{KeyframeId{99}, T_later_key, 1.0, T_cam_world_, support};
  const Vec3d p_world(0.4, 0.3, 5.0);
  const Vec3d before = later.T_cam_world(*snapshot()) * p_world;
  const Sim3d S_new_old{so3Exp(Vec3d(0.3, -0.2, 0.1)), Vec3d(2.0, 1.0, 0.0), 1.7};
  map_.moveKeyframe({kFirst, S_new_old});
  const Vec3d after = later.T_cam_world(*snapshot()) * (S_new_old * p_world);
  EXPECT_LT((after - 1.7 * before).norm(), 1e-12);
}

TEST_F(AnchoredPoseTest, ServesBeforeItsKeyframeIsPublished) {
  const AnchoredPose pose{KeyframeId{99}, SE3d{}, 1.0, T_cam_world_, std::nullopt};
  EXPECT_EQ(pose.T_cam_world(*snapshot()).t, T_cam_world_.t);
}

}  // namespace
}  // namespace glide
