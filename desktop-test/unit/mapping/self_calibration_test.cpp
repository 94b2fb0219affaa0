#include "mapping/self_calibration.h"

#include "support/mapped_scene.h"

#include "mapping/fusion.h"
#include "mapping/new_landmarks.h"
#include "mapping/window_adjustment.h"

#include "map/map_consistency.h"
#include "map/map_restore.h"
#include "optimize/radial_calibration.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::walk;

// Corners at the edge of the 80-degree lens lie 10 px off.
constexpr double kWrongDk1 = 0.03;

class SelfCalibrationTest : public testing::Test {
 protected:
  SelfCalibrationTest() : scene_(smallCloud(), {}), truth_(scene_.cloud.camera()) {}

  /// Eight keyframes, mapped by a camera whose k1 is off by `dk1`.
  void mapWith(double dk1) {
    state().camera = state().given_camera = withRadial(truth_, dk1);
    state().bearings = BearingCache(state().camera);
    scene_.start();
    for (int step = 2; step < 8; ++step) {
      const KeyframeId id = scene_.insert(walk(step));
      createLandmarks(&state(), id, nullptr);
      fuseAround(&state(), id, nullptr);
      adjustWindow(&state(), windowAround(state().map, id, 20), {});
    }
    ASSERT_EQ(state().map.keyframes().size(), 8U);
  }

  MapperState& state() { return scene_.state; }
  double k1Error() const {
    return scene_.state.camera.coefficients()[0] - truth_.coefficients()[0];
  }

  MappedScene scene_;
  const CameraModel truth_;
  SelfCalibration calibration_;
};

TEST_F(SelfCalibrationTest, CorrectsTheLensAndTheMap) {
  mapWith(kWrongDk1);
  const double before = scene_.keyframeError();
  EXPECT_TRUE(calibration_.update(&state()));
  EXPECT_NEAR(k1Error(), 0.0, 0.02 * kWrongDk1);
  EXPECT_LT(scene_.keyframeError(), 0.2 * before);
  ASSERT_NE(state().corrected_camera, nullptr);
  EXPECT_EQ(state().corrected_camera->coefficients(), state().camera.coefficients());
  EXPECT_EQ(checkConsistency(state().map), "");
}

TEST_F(SelfCalibrationTest, LeavesAMapAloneWhoseLensIsRight) {
  mapWith(0.0);
  const auto before = scene_.map();
  EXPECT_FALSE(calibration_.update(&state()));
  EXPECT_EQ(state().corrected_camera, nullptr);
  EXPECT_EQ(k1Error(), 0.0);
  const auto after = scene_.map();
  for (std::size_t i = 0; i < before->keyframes().size(); ++i)
    EXPECT_EQ(before->keyframes()[i].T_cam_world.t, after->keyframes()[i].T_cam_world.t);
  ASSERT_EQ(before->landmarks().size(), after->landmarks().size());
  for (std::size_t i = 0; i < before->landmarks().size(); ++i)
    EXPECT_EQ(before->landmarks()[i].p_world, after->landmarks()[i].p_world);
}

TEST_F(SelfCalibrationTest, TriesOnceForEachSizeOfTheMap) {
  mapWith(kWrongDk1);
  EXPECT_TRUE(calibration_.update(&state()));
  state().useCamera(withRadial(truth_, kWrongDk1));
  EXPECT_FALSE(calibration_.update(&state()));
  calibration_.beginMap();
  EXPECT_TRUE(calibration_.update(&state()));
}

TEST_F(SelfCalibrationTest, RefusesWhatIsNoRestOfADistortion) {
  mapWith(kWrongDk1);
  state().given_camera = withRadial(truth_, 0.2);
  EXPECT_FALSE(calibration_.update(&state()));
  EXPECT_EQ(state().corrected_camera, nullptr);
}

TEST_F(SelfCalibrationTest, CanBeTurnedOff) {
  mapWith(kWrongDk1);
  Config config;
  config.calibration.refinement = CalibrationRefinement::off;
  MapperState off(config, truth_);
  restoreMap(*scene_.map(), &off.map);
  off.camera = state().camera;
  EXPECT_FALSE(calibration_.update(&off));
}

}  // namespace
}  // namespace glide
