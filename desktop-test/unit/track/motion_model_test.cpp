#include "track/motion_model.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

constexpr std::int64_t kFrame_ns = 50'000'000;

AnchoredPose poseAt(const SE3d& T_cam_world) {
  return {KeyframeId{0}, T_cam_world, 1.0, SE3d{}, {}};
}

TEST(MotionModel, KnowsNothingBeforeTheFirstFrame) {
  EXPECT_FALSE(MotionModel().predict(0, MapSnapshot()).has_value());
}

TEST(MotionModel, ContinuesAConstantTwistExactly) {
  const MapSnapshot map;
  Vec6d twist;
  twist << 0.02, -0.01, 0.03, 0.05, 0.01, -0.02;
  MotionModel motion;
  SE3d T_cam_world;
  for (int i = 0; i < 3; ++i) {
    motion.update(i * kFrame_ns, poseAt(T_cam_world), map);
    T_cam_world = SE3d::exp(twist) * T_cam_world;
  }
  const SE3d predicted = motion.predict(3 * kFrame_ns, map).value();
  EXPECT_LT((predicted * T_cam_world.inverse()).log().norm(), 1e-9);
}

TEST(MotionModel, ScalesTheMotionWithTheTimeBetweenFrames) {
  const MapSnapshot map;
  MotionModel motion;
  SE3d moved;
  moved.t = Vec3d(0.1, 0.0, 0.0);
  motion.update(0, poseAt(SE3d{}), map);
  motion.update(kFrame_ns, poseAt(moved), map);
  EXPECT_NEAR(motion.predict(3 * kFrame_ns, map)->t.x(), 0.3, 1e-9);
}

TEST(MotionModel, ExpectsTheCameraWhereItWasAfterALossOrALongGap) {
  const MapSnapshot map;
  MotionModel motion;
  SE3d moved;
  moved.t = Vec3d(0.1, 0.0, 0.0);
  motion.update(0, poseAt(SE3d{}), map);
  motion.update(kFrame_ns, poseAt(moved), map);
  EXPECT_NEAR(motion.predict(60 * kFrame_ns, map)->t.x(), 0.1, 1e-12);
  motion.stop();
  EXPECT_NEAR(motion.predict(2 * kFrame_ns, map)->t.x(), 0.1, 1e-12);
}

}  // namespace
}  // namespace glide
