#include "photometric/cpu_aligner.h"

#include "unit/photometric/align_fixture.h"

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

class CpuAlignerOfLens : public testing::TestWithParam<DistortionModel> {};

TEST_P(CpuAlignerOfLens, ConvergesFromAPerturbedPose) {
  const AlignScenario scenario(makeCamera(GetParam(), test::kWidth, test::kHeight));
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  expectAccurate(result, scenario);
  EXPECT_NEAR(result.gain, 1.0, 0.02);
  EXPECT_GT(result.inliers, 350);
}

std::string lensName(const testing::TestParamInfo<DistortionModel>& lens) {
  switch (lens.param) {
    case DistortionModel::none:
      return "pinhole";
    case DistortionModel::radial_tangential:
      return "radialTangential";
    case DistortionModel::kannala_brandt4:
      break;
  }
  return "fisheye";
}

INSTANTIATE_TEST_SUITE_P(Lenses,
                         CpuAlignerOfLens,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4),
                         lensName);

class CpuAlignerOfPatch : public testing::TestWithParam<int> {};

TEST_P(CpuAlignerOfPatch, ConvergesWithEveryPatchSize) {
  AlignScenario scenario = smallScenario();
  scenario.config.patch_size = GetParam();
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  const PoseError error = poseError(result.T_cam_ref, scenario.truth());
  // Half the resolution, and the largest patch straddles the panels' edges.
  EXPECT_LT(error.mm, 3.0 * test::kMaxErrorMm);
  EXPECT_LT(error.degrees, 3.0 * test::kMaxErrorDegrees);
}

INSTANTIATE_TEST_SUITE_P(OddSizes, CpuAlignerOfPatch, testing::Values(5, 7, 9, 11, 13, 15));

TEST(CpuAligner, StaysAtTheTruthOfTheReferenceItself) {
  const AlignScenario scenario = pinholeScenario();
  const std::unique_ptr<CpuAligner> aligner = scenario.alignerWithReference();
  const AlignResult result = aligner->align(test::perturbation());
  const PoseError error = poseError(result.T_cam_ref, SE3d{});
  EXPECT_LT(error.mm, 1e-3);
  EXPECT_LT(error.degrees, 1e-4);
  EXPECT_LT(result.rms, 0.05);
  EXPECT_EQ(result.visible, result.points);
}

TEST(CpuAligner, AlignsImagesOfOddSize) {
  const AlignScenario scenario(makeCamera(DistortionModel::radial_tangential, 641, 479));
  expectAccurate(scenario.align(scenario.perturbedGuess()), scenario);
}

TEST(CpuAligner, ReportsASymmetricPositiveInformationMatrix) {
  const AlignScenario scenario = smallScenario();
  const AlignResult result = scenario.align(scenario.perturbedGuess());
  EXPECT_EQ(result.H, Mat6d(result.H.transpose()));
  const Eigen::SelfAdjointEigenSolver<Mat6d> solver(result.H);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 1.0);
}

TEST(CpuAligner, IsNotValidBeforeAReference) {
  const AlignScenario scenario = smallScenario();
  const std::unique_ptr<CpuAligner> aligner =
      CpuAligner::create(scenario.config, scenario.camera).value();
  EXPECT_FALSE(aligner->hasReference());
  EXPECT_FALSE(aligner->align(SE3d{}).valid);
  aligner->loadFrame(scenario.referenceImage().view());
  EXPECT_FALSE(aligner->align(SE3d{}).valid);
  aligner->promoteReference(scenario.alignPoints());
  EXPECT_TRUE(aligner->hasReference());
  EXPECT_TRUE(aligner->align(SE3d{}).valid);
}

TEST(CpuAligner, SkipsLevelsThatHoldNoPatch) {
  AlignScenario scenario(makeCamera(DistortionModel::none, 80, 60));
  scenario.T_ref_cam = SE3d{};
  const AlignResult result = scenario.align(SE3d{});
  EXPECT_TRUE(result.valid);
  EXPECT_GT(result.iterations[0], 0);
  EXPECT_GT(result.iterations[1], 0);
  EXPECT_EQ(result.iterations[3], 0);  // 10 x 8 pixels: smaller than the patch
  EXPECT_EQ(result.iterations[5], 0);  // not built
}

TEST(CpuAligner, IteratesNoMoreThanAllowedAndStopsWhenConverged) {
  AlignScenario scenario = smallScenario();
  scenario.config.max_iterations = 3;
  const AlignResult limited = scenario.align(scenario.perturbedGuess());
  EXPECT_EQ(*std::max_element(limited.iterations.begin(), limited.iterations.end()), 3);
  scenario.config.convergence = 0.1;
  const AlignResult coarse = scenario.align(scenario.truth());
  EXPECT_EQ(*std::max_element(coarse.iterations.begin(), coarse.iterations.end()), 1);
}

TEST(CpuAligner, UsesNoMorePointsThanConfigured) {
  AlignScenario scenario = smallScenario();
  scenario.config.max_points = 50;
  const AlignResult result = scenario.align(scenario.truth());
  EXPECT_LE(result.points, 50);
  EXPECT_GT(result.points, 30);
}

TEST(CpuAligner, GivesTheSameBytesTwice) {
  const AlignScenario scenario = smallScenario();
  const AlignResult first = scenario.align(scenario.perturbedGuess());
  const AlignResult second = scenario.align(scenario.perturbedGuess());
  EXPECT_EQ(first.T_cam_ref.t, second.T_cam_ref.t);
  EXPECT_EQ(first.T_cam_ref.q.coeffs(), second.T_cam_ref.q.coeffs());
  EXPECT_EQ(first.H, second.H);
}

TEST(CpuAligner, AgreesWithItselfOnEveryInstructionSet) {
  const AlignScenario scenario = smallScenario();
  const AlignResult best = scenario.align(scenario.perturbedGuess());
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    const AlignResult result = scenario.align(scenario.perturbedGuess());
    const PoseError difference = poseError(result.T_cam_ref, best.T_cam_ref);
    EXPECT_LT(difference.mm, 0.01);
    EXPECT_LT(difference.degrees, 0.001);
    EXPECT_EQ(result.visible, best.visible);
    EXPECT_NEAR(result.rms, best.rms, 1e-3);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(CpuAligner, RefusesAConfigurationItCannotRun) {
  const CameraModel camera = makeCamera(DistortionModel::none, 64, 48);
  for (const int patch_size : {1, 8, 17}) {
    Config::Direct config;
    config.patch_size = patch_size;
    const auto aligner = CpuAligner::create(config, camera);
    ASSERT_FALSE(aligner.ok());
    EXPECT_NE(aligner.error().message.find("patch_size"), std::string::npos);
  }
  Config::Direct config;
  config.levels = 9;
  EXPECT_FALSE(CpuAligner::create(config, camera).ok());
}

TEST(CpuAligner, ReportsTheTimeOfEachStage) {
  const AlignScenario scenario = smallScenario();
  const std::unique_ptr<CpuAligner> aligner = scenario.alignerWithReference();
  aligner->align(SE3d{});
  EXPECT_GT(aligner->times().pyramid_ms, 0.0);
  EXPECT_GT(aligner->times().precompute_ms, 0.0);
  EXPECT_GT(aligner->times().align_ms, 0.0);
}

}  // namespace
}  // namespace glide
