#include "unit/photometric/align_fixture.h"

#include "photometric/cpu_aligner.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace glide {
namespace {

using test::AlignScenario;
using test::expectAccurate;
using test::makeCamera;
using test::pinholeScenario;
using test::poseError;
using test::PoseError;
using test::smallScenario;
using test::twist;

struct ExposureCase {
  double reference_gain, frame_gain, frame_bias;
};

class CpuAlignerOfExposure : public testing::TestWithParam<ExposureCase> {};

TEST_P(CpuAlignerOfExposure, RecoversGainAndBias) {
  AlignScenario scenario = pinholeScenario();
  scenario.reference_exposure.gain = GetParam().reference_gain;
  scenario.frame_exposure = {GetParam().frame_gain, GetParam().frame_bias};
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  const double gain = GetParam().frame_gain / GetParam().reference_gain;
  EXPECT_NEAR(result.gain / gain, 1.0, 0.02);
  EXPECT_NEAR(result.bias, GetParam().frame_bias, 3.0);
  expectAccurate(result, scenario);
}

INSTANTIATE_TEST_SUITE_P(HalfToDouble,
                         CpuAlignerOfExposure,
                         testing::Values(ExposureCase{1.0, 0.5, 0.0},
                                         ExposureCase{1.0, 0.7, 40.0},
                                         ExposureCase{1.0, 1.2, -20.0},
                                         ExposureCase{0.5, 0.75, 25.0},
                                         ExposureCase{0.5, 1.0, 0.0}));

TEST(CpuAligner, LeavesBrightnessAloneWhenToldSo) {
  AlignScenario scenario = smallScenario();
  scenario.config.photometric = PhotometricModel::none;
  scenario.frame_exposure = {1.1, 5.0};
  const AlignResult result = scenario.align(scenario.truth());
  EXPECT_EQ(result.gain, 1.0);
  EXPECT_EQ(result.bias, 0.0);
  EXPECT_GT(result.rms, 5.0);
}

/// Something new in front of a sixth of the image.
void addOccluder(AlignScenario* scenario) {
  scenario->scene.add({Vec3d(0.1, -0.05, 0.8), Vec3d(0.27, 0.0, 0.0), Vec3d(0.0, 0.17, 0.0), 9});
}

TEST(CpuAligner, ToleratesAnOccluder) {
  AlignScenario scenario = pinholeScenario();
  const std::unique_ptr<CpuAligner> aligner = scenario.alignerWithReference();
  addOccluder(&scenario);
  aligner->loadFrame(scenario.frameImage().view());
  const AlignResult result = aligner->align(scenario.perturbedGuess());
  const PoseError error = poseError(result.T_cam_ref, scenario.truth());
  EXPECT_TRUE(result.valid);
  EXPECT_LT(result.inliers, result.visible * 9 / 10);
  EXPECT_LT(error.mm, 1.0);
  EXPECT_LT(error.degrees, 0.05);
}

TEST(CpuAligner, TracksWhenPointsLeaveTheImage) {
  AlignScenario scenario = pinholeScenario();
  scenario.T_ref_cam = SE3d::exp(twist({0.01, 0.0, 0.0}, {0.0, 0.25, 0.0}));
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  const PoseError error = poseError(result.T_cam_ref, scenario.truth());
  EXPECT_TRUE(result.valid);
  EXPECT_LT(result.visible, result.points * 4 / 5);
  EXPECT_GT(result.visible, result.points / 2);
  EXPECT_LT(error.mm,
            10.0);  // patches are seen 14 degrees turned, which fixed offsets do not follow
  EXPECT_LT(error.degrees, 0.3);
}

TEST(CpuAligner, ConvergesWithConstantHessian) {
  AlignScenario scenario = pinholeScenario();
  scenario.config.hessian = HessianMode::constant;
  const std::unique_ptr<CpuAligner> aligner = scenario.alignerWithReference();
  const AlignResult at_reference = aligner->align(SE3d{});
  aligner->loadFrame(scenario.frameImage().view());
  const AlignResult result = aligner->align(scenario.perturbedGuess());
  EXPECT_TRUE(result.valid);
  EXPECT_LT(poseError(result.T_cam_ref, scenario.truth()).mm, 1.0);
  EXPECT_LT(result.visible, result.points);
  EXPECT_EQ(result.H, at_reference.H);  // the points that left are still in it
}

TEST(CpuAligner, RefusesTooFewPoints) {
  AlignScenario scenario = smallScenario();
  scenario.points = scenario.config.min_points - 1;
  const AlignResult result = scenario.align(scenario.truth());
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.visible, 0);
}

TEST(CpuAligner, RefusesAPoseThatSeesTooFewPoints) {
  const AlignScenario scenario = smallScenario();
  const SE3d turned_away = SE3d::exp(twist({0.0, 0.0, 0.0}, {0.0, 3.1, 0.0}));
  const AlignResult result = scenario.align(turned_away);
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.iterations[0], 0);
}

TEST(CpuAligner, RefusesAGuessThatIsNotANumber) {
  const AlignScenario scenario = smallScenario();
  SE3d guess;
  guess.t.x() = std::nan("");
  EXPECT_FALSE(scenario.align(guess).valid);
}

TEST(CpuAligner, RefusesAReferenceWithoutTexture) {
  AlignScenario scenario = smallScenario();
  scenario.reference_exposure = {0.0, 100.0};
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  EXPECT_FALSE(result.valid);
  EXPECT_TRUE(result.T_cam_ref.t.allFinite());
}

TEST(CpuAligner, SurvivesAFrameWithoutTexture) {
  AlignScenario scenario = smallScenario();
  scenario.frame_exposure = {0.0, 100.0};
  const AlignResult result = scenario.align(scenario.truth());
  EXPECT_TRUE(result.T_cam_ref.t.allFinite());
  EXPECT_GT(result.rms, 0.5 * result.contrast);
}

}  // namespace
}  // namespace glide
