#include "mapping/window_adjustment.h"

#include "support/mapped_scene.h"

#include "mapping/fusion.h"
#include "mapping/new_landmarks.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::walk;

class WindowAdjustmentTest : public testing::Test {
 protected:
  WindowAdjustmentTest() : scene_(smallCloud(), {}) {
    scene_.start();
    for (int step = 2; step < 7; ++step) {
      const KeyframeId id = scene_.insert(walk(step));
      createLandmarks(&scene_.state, id, nullptr);
      fuseAround(&scene_.state, id, nullptr);
    }
  }

  Map& map() { return scene_.state.map; }
  double spread() {
    double sum = 0.0;
    const Vec3d first = map().keyframes().begin()->second.T_cam_world.inverse().t;
    for (const auto& entry : map().keyframes()) {
      sum += (entry.second.T_cam_world.inverse().t - first).norm();
    }
    return sum;
  }
  // Every keyframe but the first, and every landmark.
  void disturb(double sigma) {
    std::mt19937_64 random(3);
    const KeyframeId first = map().keyframes().begin()->first;
    for (const auto& [id, keyframe] : map().keyframes()) {
      if (id == first) continue;
      map().setPose(id, test::perturbed(keyframe.T_cam_world, sigma, sigma, &random));
    }
    for (const LandmarkId id : map().landmarkIds()) {
      map().setPosition(id, map().landmark(id)->p_world + test::randomVector(sigma, &random));
    }
  }

  MappedScene scene_;
  BundleOptions options_;
};

TEST_F(WindowAdjustmentTest, TakesTheWholeMapWhenItIsSmallAndFixesItsFirstKeyframe) {
  const AdjustmentWindow window = windowAround(map(), scene_.newest(), 20);
  EXPECT_EQ(window.moving.size(), map().keyframes().size() - 1);
  ASSERT_EQ(window.fixed.size(), 1U);
  EXPECT_EQ(window.fixed[0], KeyframeId{0});
  EXPECT_EQ(window.landmarks, map().landmarkIds());
}

TEST_F(WindowAdjustmentTest, FixesTheKeyframesThatSeeTheLandmarksFromOutside) {
  const AdjustmentWindow window = windowAround(map(), scene_.newest(), 3);
  EXPECT_EQ(window.moving.size(), 3U);
  EXPECT_TRUE(std::count(window.moving.begin(), window.moving.end(), scene_.newest()));
  EXPECT_GE(window.fixed.size(), 2U);
  for (const KeyframeId id : window.fixed) {
    EXPECT_FALSE(std::count(window.moving.begin(), window.moving.end(), id));
  }
}

TEST_F(WindowAdjustmentTest, RecoversADisturbedMap) {
  disturb(0.005);
  const double before = scene_.keyframeError();
  const BundleSummary summary =
      adjustWindow(&scene_.state, windowAround(map(), scene_.newest(), 20), options_);
  EXPECT_TRUE(summary.usable);
  EXPECT_LT(scene_.keyframeError(), before / 20.0);
  EXPECT_LT(scene_.landmarkError(), 1e-3);
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(WindowAdjustmentTest, KeepsTheScaleWhenOnlyOneKeyframeIsFixed) {
  disturb(0.005);
  const double before = spread();
  adjustWindow(&scene_.state, windowAround(map(), scene_.newest(), 20), options_);
  EXPECT_NEAR(spread(), before, 1e-9 * before);
}

TEST_F(WindowAdjustmentTest, LeavesFixedKeyframesWhereTheyAre) {
  disturb(0.003);
  const AdjustmentWindow window = windowAround(map(), scene_.newest(), 3);
  std::vector<SE3d> poses;
  for (const KeyframeId id : window.fixed) poses.push_back(map().keyframe(id)->T_cam_world);
  adjustWindow(&scene_.state, window, options_);
  for (std::size_t i = 0; i < window.fixed.size(); ++i) {
    EXPECT_EQ(map().keyframe(window.fixed[i])->T_cam_world.t, poses[i].t);
  }
}

TEST_F(WindowAdjustmentTest, RemovesObservationsThatDoNotFit) {
  // Two landmarks swap their features in one keyframe, forty times.
  std::vector<LandmarkId> swapped;
  const KeyframeId id = scene_.newest();
  for (const LandmarkId landmark : map().keyframe(id)->landmarks) {
    if (landmark == kNoLandmark || swapped.size() >= 40) continue;
    if (map().landmark(landmark)->observations.size() >= 4) swapped.push_back(landmark);
  }
  ASSERT_GE(swapped.size(), 20U);
  for (std::size_t i = 0; i + 1 < swapped.size(); i += 2) {
    const Observation a = map().landmark(swapped[i])->observations.back();
    const Observation b = map().landmark(swapped[i + 1])->observations.back();
    map().removeObservation(swapped[i], id);
    map().removeObservation(swapped[i + 1], id);
    map().addObservation(swapped[i], b);
    map().addObservation(swapped[i + 1], a);
  }
  adjustWindow(&scene_.state, windowAround(map(), id, 20), options_);
  int left = 0;
  for (const LandmarkId landmark : swapped) {
    const Landmark* kept = map().landmark(landmark);
    if (kept != nullptr && kept->observations.back().keyframe == id) ++left;
  }
  EXPECT_LE(left, 2);  // swapped corners may lie close together
  EXPECT_LT(scene_.keyframeError(), 1e-3);
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(WindowAdjustmentTest, ChangesNothingWithoutLandmarks) {
  Map& map = this->map();
  for (const LandmarkId id : map.landmarkIds()) map.removeLandmark(id);
  const BundleSummary summary =
      adjustWindow(&scene_.state, windowAround(map, scene_.newest(), 20), options_);
  EXPECT_FALSE(summary.usable);
}

}  // namespace
}  // namespace glide
