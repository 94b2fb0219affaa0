#include "track/switch_policy.h"

#include <gtest/gtest.h>

#include <numbers>

namespace glide {
namespace {

DirectEvidence goodEvidence() {
  DirectEvidence evidence;
  evidence.align.valid = true;
  evidence.align.rms = 5.0;
  evidence.align.contrast = 30.0;
  evidence.align.points = 200;
  evidence.align.visible = 190;
  evidence.align.inliers = 180;
  evidence.align.T_cam_ref.t = Vec3d(0.02, 0.0, 0.0);
  evidence.median_depth = 1.0;
  return evidence;
}

const Config::Direct kConfig;

TEST(SwitchPolicy, AcceptsAFrameThatAlignedWell) {
  EXPECT_EQ(decideSwitch(kConfig, goodEvidence()), SwitchReason::none);
}

TEST(SwitchPolicy, RefusesAnInvalidSolve) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.valid = false;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::solve_failed);
}

TEST(SwitchPolicy, RefusesWhenMostPointsHaveLeftTheView) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.visible = 100;
  evidence.align.inliers = 100;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::too_few_visible);
}

TEST(SwitchPolicy, RefusesAHighPatchError) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.rms = kConfig.max_rms + 0.1;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
}

TEST(SwitchPolicy, RefusesAPatchErrorThatJumps) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.rms = 15.0;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);  // nothing to compare with
  evidence.last_rms = 8.0;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
  evidence.last_rms = 5.0;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
}

TEST(SwitchPolicy, RefusesAPoseThatNobodyExpectedWhenThePatchesFitWorseThere) {
  DirectEvidence evidence = goodEvidence();
  evidence.last_rms = 6.7;
  evidence.align.rms = 14.5;  // below max_rms_growth
  evidence.surprise = 0.17;   // half a metre and five degrees before a wall at six metres
  evidence.usual_surprise = 0.01;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
}

TEST(SwitchPolicy, AcceptsAJerkOfTheHandThatThePatchesFollow) {
  DirectEvidence evidence = goodEvidence();
  evidence.last_rms = 5.0;
  evidence.surprise = 0.17;
  evidence.usual_surprise = 0.01;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

TEST(SwitchPolicy, AcceptsPatchesThatFitWorseWhereTheCameraWasExpected) {
  DirectEvidence evidence = goodEvidence();
  evidence.last_rms = 6.7;
  evidence.align.rms = 14.5;
  evidence.surprise = 0.03;
  evidence.usual_surprise = 0.01;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

TEST(SwitchPolicy, TakesNoJumpFromNoiseToNoiseForOne) {
  DirectEvidence evidence = goodEvidence();
  evidence.last_rms = 0.2;
  evidence.align.rms = 2.0;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

TEST(SwitchPolicy, MeasuresThePatchErrorAgainstTheReferencesContrast) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.contrast = 4.0;  // a dull wall: five grey levels of error mean nothing was matched
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
}

TEST(SwitchPolicy, RefusesAFrameOfSomethingElseWhoseGainRanIntoItsLimits) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.gain = 0.2;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
  evidence.align.gain = 0.5;  // half the exposure is nothing unusual
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

TEST(SwitchPolicy, RefusesWhenMostVisiblePatchesDisagree) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.inliers = 60;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::photometric_error);
}

TEST(SwitchPolicy, MeasuresTheBaselineAgainstTheSceneDepth) {
  DirectEvidence evidence = goodEvidence();
  evidence.align.T_cam_ref.t = Vec3d(kConfig.max_baseline * 1.01, 0.0, 0.0);
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::baseline);
  evidence.median_depth = 2.0;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

TEST(SwitchPolicy, RefusesALargeRotation) {
  DirectEvidence evidence = goodEvidence();
  const double angle = (kConfig.max_rotation_deg + 0.5) * std::numbers::pi / 180.0;
  evidence.align.T_cam_ref.q = so3Exp(Vec3d(0.0, angle, 0.0));
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::rotation);
}

TEST(SwitchPolicy, RetiresAReferenceThatHasServedItsTime) {
  DirectEvidence evidence = goodEvidence();
  evidence.direct_frames = kConfig.max_direct_frames;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::max_direct_frames);
  evidence.direct_frames = kConfig.max_direct_frames - 1;
  EXPECT_EQ(decideSwitch(kConfig, evidence), SwitchReason::none);
}

}  // namespace
}  // namespace glide
