#include "mapping/bearing_cache.h"

#include "support/synthetic_problem.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

Keyframe keyframeWith(const Vec2f& uv) {
  Keyframe keyframe;
  std::vector<Feature> features(1);
  features[0].uv = uv;
  keyframe.features = std::make_shared<FeatureSet>(features, std::vector<Descriptor>(1), 640, 480);
  return keyframe;
}

TEST(BearingCache, HoldsTheUnitBearingOfEveryFeature) {
  const CameraModel camera = test::syntheticCamera(DistortionModel::kannala_brandt4);
  BearingCache cache(camera);
  const std::vector<Vec3d>& bearings = cache.of(keyframeWith(Vec2f(100.0F, 50.0F)));
  ASSERT_EQ(bearings.size(), 1U);
  EXPECT_NEAR(bearings[0].norm(), 1.0, 1e-12);
  EXPECT_NEAR((*camera.project(bearings[0]) - Vec2d(100.0, 50.0)).norm(), 0.0, 1e-6);
}

TEST(BearingCache, ComputesOncePerKeyframeUntilItIsForgotten) {
  BearingCache cache(test::syntheticCamera(DistortionModel::none));
  const Vec3d first = cache.of(keyframeWith(Vec2f(10.0F, 10.0F)))[0];
  EXPECT_EQ(cache.of(keyframeWith(Vec2f(500.0F, 10.0F)))[0], first);  // the same id
  cache.forget(KeyframeId{0});
  EXPECT_NE(cache.of(keyframeWith(Vec2f(500.0F, 10.0F)))[0], first);
}

}  // namespace
}  // namespace glide
