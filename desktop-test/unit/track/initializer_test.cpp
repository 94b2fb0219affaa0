#include "track/initializer.h"

#include "support/textured_scene.h"

#include "feature/orb_extractor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace glide {
namespace {

/// A camera that moves before a textured wall.
class InitializerTest : public ::testing::Test {
 protected:
  InitializerTest() {
    config_.camera.width = 320;
    config_.camera.height = 240;
    config_.camera.fx = config_.camera.fy = 260.0;
    config_.camera.cx = 159.5;
    config_.camera.cy = 119.5;
    config_.initialization.min_matches = 60;
    camera_.emplace(CameraModel::create(config_.camera).value());
    extractor_.emplace(config_.features);
    initializer_.emplace(config_, *camera_);
  }

  std::optional<InitialMap> feed(const SE3d& T_world_cam) {
    const ImageU8 image = scene_.render(*camera_, T_world_cam, {});
    t_ns_ += 33'333'333;
    return initializer_->update(
        t_ns_, std::make_shared<const FeatureSet>(extractor_->extract(image.view(), 1500)));
  }

  static SE3d at(double x) {
    SE3d T_world_cam;
    T_world_cam.t = Vec3d(x, 0.2 * x, -0.1 * x);
    T_world_cam.q = so3Exp(Vec3d(0.0, -0.2 * x, 0.3 * x));
    return T_world_cam;
  }

  Config config_;
  test::TexturedScene scene_ = test::TexturedScene::wallWithPanels();
  std::optional<CameraModel> camera_;
  std::optional<OrbExtractor> extractor_;
  std::optional<Initializer> initializer_;
  std::int64_t t_ns_ = 0;
};

TEST_F(InitializerTest, FindsTheMotionAndGivesTheMedianDepthItsUnit) {
  std::optional<InitialMap> map;
  double x = 0.0;
  for (int i = 0; i < 30 && !map; ++i, x += 0.012) map = feed(at(x));
  ASSERT_TRUE(map.has_value());
  const SE3d T_b_a = at(x - 0.012).inverse();
  EXPECT_LT(so3Log(map->b.T_cam_world.q * T_b_a.q.conjugate()).norm(), 0.01);
  EXPECT_GT(map->b.T_cam_world.t.normalized().dot(T_b_a.t.normalized()), 0.995);
  std::vector<double> depths;
  for (const InitialMap::Point& point : map->points) depths.push_back(point.p_world.z());
  std::sort(depths.begin(), depths.end());
  ASSERT_GE(depths.size(), 50U);
  EXPECT_NEAR(depths[depths.size() / 2], config_.initialization.median_depth, 1e-9);
}

TEST_F(InitializerTest, SaysThatTheCameraOnlyTurned) {
  for (int i = 0; i < 12; ++i) {
    SE3d T_world_cam;
    T_world_cam.q = so3Exp(Vec3d(0.0, 0.01 * i, 0.0));
    EXPECT_FALSE(feed(T_world_cam).has_value());
  }
  const InitializationStatus status = initializer_->progress().status;
  EXPECT_TRUE(status == InitializationStatus::pure_rotation ||
              status == InitializationStatus::too_little_motion);
  EXPECT_GT(initializer_->progress().matches, 60);
}

TEST_F(InitializerTest, StartsOverWhenTheViewHasNothingInCommonWithTheFirst) {
  feed(at(0.0));
  feed(at(0.01));
  SE3d elsewhere;
  elsewhere.t = Vec3d(0.9, 0.5, 0.2);
  elsewhere.q = so3Exp(Vec3d(0.0, 0.5, 1.5));
  EXPECT_FALSE(feed(elsewhere).has_value());
  EXPECT_EQ(initializer_->progress().status, InitializationStatus::too_few_matches);
}

}  // namespace
}  // namespace glide
