#include "vit/vit_velocity.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr std::int64_t kStep_ns = 100'000'000;
constexpr float kTolerance = 1e-5F;

/// The camera goes along x, one step after the other.
class VitVelocityTest : public ::testing::Test {
 protected:
  vit_pose_data step(float px) { return step(px, kStep_ns); }
  vit_pose_data step(float px, std::int64_t step_ns) {
    t_ns_ += step_ns;
    vit_pose_data pose{};
    pose.timestamp = t_ns_;
    pose.px = px;
    velocity_.add(result_, &pose);
    return pose;
  }

  VitVelocity velocity_;
  FrameResult result_;
  std::int64_t t_ns_ = 0;
};

TEST_F(VitVelocityTest, IsTheDifferenceOfTwoPoses) {
  EXPECT_EQ(step(0.0F).vx, 0.0F);
  EXPECT_NEAR(step(0.1F).vx, 1.0F, kTolerance);
  EXPECT_EQ(step(0.2F, 10 * kStep_ns).vx, 0.0F) << "after a gap";
  velocity_.forget();
  EXPECT_EQ(step(0.3F).vx, 0.0F);
}

TEST_F(VitVelocityTest, DoesNotTakeACorrectionOfTheMapForMotion) {
  step(0.0F);
  result_.correction = WorldCorrection{0.5, 0.0, 1.0};
  EXPECT_EQ(step(0.6F).vx, 0.0F);
  result_.correction.reset();
  EXPECT_NEAR(step(0.7F).vx, 1.0F, kTolerance);
}

TEST_F(VitVelocityTest, DoesNotTakeAnotherMapForMotion) {
  step(0.0F);
  ++result_.map_generation;
  EXPECT_EQ(step(0.6F).vx, 0.0F);
  EXPECT_NEAR(step(0.7F).vx, 1.0F, kTolerance);
}

}  // namespace
}  // namespace glide::test
