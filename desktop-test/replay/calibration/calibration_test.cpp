#include "replay/calibration/calibration.h"

#include "replay/common/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace glide::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kEuroc = R"(# General sensor definitions.
sensor_type: camera
T_BS:
  cols: 4
  rows: 4
  data: [0.0, -1.0, 0.0, 0.1,
         1.0,  0.0, 0.0, 0.2,
         0.0,  0.0, 1.0, 0.3,
         0.0,  0.0, 0.0, 1.0]
resolution: [752, 480]
camera_model: pinhole
intrinsics: [458.654, 457.296, 367.215, 248.375] #fu, fv, cu, cv
distortion_model: radial-tangential
distortion_coefficients: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]
)";

const std::string kKalibr = R"(cam0:
  T_cam_imu:
  - [1.0, 0.0, 0.0, 0.5]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  camera_model: pinhole
  distortion_coeffs: [-0.002, -0.078, 0.088, -0.033]
  distortion_model: equidistant
  intrinsics: [192.5, 193.6, 162.0, 125.0]
  resolution: [320, 240]
)";

const std::string kOrb = R"(%YAML:1.0

# ORB-SLAM
Camera.fx: 517.3
Camera.fy: 516.5
Camera.cx: 318.6
Camera.cy: 255.3
Camera.k1: 0.2624
Camera.k2: -0.9531
Camera.p1: -0.0054
Camera.p2: 0.0026
Camera.k3: 1.1633
Camera.width: 640
Camera.height: 480
Camera.fps: 30.0
)";

const std::string kOwn = R"(camera:
  width: 640
  height: 480
  fx: 500
  fy: 501
  cx: 320
  cy: 240
  distortion: kannala_brandt4
  coefficients: [0.1, 0.01, 0.0, 0.0]
  T_body_cam: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Result<Calibration> load(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "glide_calibration_test.yaml";
  EXPECT_TRUE(writeFile(file, text).ok());
  return loadCalibration(file.string());
}

std::string faultOf(const std::string& text) {
  const Result<Calibration> calibration = load(text);
  return calibration ? "" : calibration.error().message;
}

TEST(Calibration, ReadsEurocWithTheCamerasPoseInTheBody) {
  const auto calibration = load(kEuroc);
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  const CameraIntrinsics& camera = calibration->camera;
  EXPECT_EQ(camera.width, 752);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.fx, 458.654);
  EXPECT_EQ(camera.cy, 248.375);
  EXPECT_EQ(camera.distortion, DistortionModel::radial_tangential);
  EXPECT_THAT(camera.coefficients,
              ElementsAre(-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05));
  ASSERT_TRUE(calibration->T_body_cam.has_value());
  const Vec3d p_body = *calibration->T_body_cam * Vec3d(1, 0, 0);
  EXPECT_LT((p_body - Vec3d(0.1, 1.2, 0.3)).norm(), 1e-12);
}

TEST(Calibration, ReadsKalibrAndInvertsItsExtrinsics) {
  const auto calibration = load(kKalibr);
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::kannala_brandt4);
  EXPECT_THAT(calibration->camera.coefficients, ElementsAre(-0.002, -0.078, 0.088, -0.033));
  EXPECT_EQ(calibration->camera.width, 320);
  EXPECT_LT((calibration->T_body_cam->t - Vec3d(-0.5, 0, 0)).norm(), 1e-12);
}

TEST(Calibration, ReadsKalibrRadtan) {
  const auto calibration = load(replaced(kKalibr, "equidistant", "radtan"));
  ASSERT_TRUE(calibration.ok());
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::radial_tangential);
}

TEST(Calibration, ReadsOrbSlamWithOpenCvsHeader) {
  const auto calibration = load(kOrb);
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::radial_tangential);
  EXPECT_THAT(calibration->camera.coefficients,
              ElementsAre(0.2624, -0.9531, -0.0054, 0.0026, 1.1633));
  EXPECT_FALSE(calibration->T_body_cam.has_value());
}

TEST(Calibration, TakesOrbSlamsThirdRadialTermAndSizeAsOptional) {
  std::string text = replaced(kOrb, "Camera.k3: 1.1633\n", "");
  text = replaced(text, "Camera.width: 640\nCamera.height: 480\n", "");
  const auto calibration = load(text);
  ASSERT_TRUE(calibration.ok());
  EXPECT_EQ(calibration->camera.coefficients.size(), 4u);
  EXPECT_EQ(calibration->camera.width, 0);
}

TEST(Calibration, TakesZeroDistortionAsNone) {
  std::string text = kOrb;
  for (const char* value : {"0.2624", "-0.9531", "-0.0054", "0.0026", "1.1633"}) {
    text = replaced(text, value, "0.0");
  }
  const auto calibration = load(text);
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::none);
  EXPECT_TRUE(calibration->camera.coefficients.empty());
}

TEST(Calibration, ReadsOrbSlam3FisheyeWithItsImuPose) {
  const auto calibration = load(R"(%YAML:1.0
---
File.version: "1.0"
Camera.type: "KannalaBrandt8"
Camera1.fx: 190.9
Camera1.fy: 190.8
Camera1.cx: 254.9
Camera1.cy: 256.8
Camera1.k1: 0.003
Camera1.k2: 0.0007
Camera1.k3: -0.002
Camera1.k4: 0.0002
Camera.width: 512
Camera.height: 512
IMU.T_b_c1: !!opencv-matrix
  rows: 4
  cols: 4
  dt: f
  data: [1, 0, 0, 0.25, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
)");
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::kannala_brandt4);
  EXPECT_THAT(calibration->camera.coefficients, ElementsAre(0.003, 0.0007, -0.002, 0.0002));
  EXPECT_EQ(calibration->T_body_cam->t.x(), 0.25);
}

TEST(Calibration, ReadsStellaNestedFisheye) {
  const auto calibration = load(R"(Camera:
  name: "fisheye"
  setup: "monocular"
  model: "fisheye"
  fx: 300
  fy: 301
  cx: 320
  cy: 240
  k1: 0.1
  k2: 0.0
  k3: 0.0
  k4: 0.0
  fps: 30
  cols: 640
  rows: 480
)");
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::kannala_brandt4);
  EXPECT_EQ(calibration->camera.fy, 301);
  EXPECT_EQ(calibration->camera.width, 640);
  EXPECT_EQ(calibration->camera.height, 480);
}

TEST(Calibration, ReadsItsOwnFormat) {
  const auto calibration = load(kOwn);
  ASSERT_TRUE(calibration.ok()) << calibration.error().message;
  EXPECT_EQ(calibration->camera.distortion, DistortionModel::kannala_brandt4);
  EXPECT_EQ(calibration->camera.fy, 501);
  EXPECT_EQ(calibration->T_body_cam->t.x(), 0.1);
}

TEST(Calibration, KnowsThePublishedTumCameras) {
  const auto first = loadCalibration("freiburg1");
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(first->camera.fx, 517.3);
  EXPECT_EQ(first->camera.coefficients.size(), 5u);
  EXPECT_EQ(loadCalibration("freiburg2")->camera.fy, 521.0);
  EXPECT_EQ(loadCalibration("freiburg3")->camera.distortion, DistortionModel::none);
}

TEST(Calibration, NamesFileLineAndFieldOfAWrongValue) {
  EXPECT_THAT(faultOf(replaced(kEuroc, "458.654", "wide")),
              HasSubstr("glide_calibration_test.yaml:12: intrinsics: has an entry that is not a"));
  EXPECT_THAT(faultOf(replaced(kEuroc, ", 248.375", "")),
              HasSubstr(":12: intrinsics: has 3 numbers, expected 4"));
  EXPECT_THAT(faultOf(replaced(kEuroc, "radial-tangential", "fov")),
              HasSubstr(":13: distortion_model: 'fov' is not supported"));
  EXPECT_THAT(faultOf(replaced(kEuroc, ", 0.07395907", "")),
              HasSubstr(":14: distortion_coefficients: has 3 numbers"));
  EXPECT_THAT(faultOf(replaced(kKalibr, "pinhole", "omni")),
              HasSubstr(":7: camera_model: 'omni' is not supported"));
  EXPECT_THAT(faultOf(replaced(kOrb, "516.5", "516,5")),
              HasSubstr(":5: Camera.fy: '516,5' is not a number"));
  EXPECT_THAT(faultOf(replaced(kOwn, "640", "640.5")), HasSubstr(":2: width: must be a whole"));
  EXPECT_THAT(faultOf(replaced(kOwn, "kannala_brandt4", "fisheye")),
              HasSubstr(":8: distortion: 'fisheye' is not supported"));
}

TEST(Calibration, NamesAMissingField) {
  EXPECT_THAT(faultOf(replaced(kEuroc, "resolution: [752, 480]\n", "")),
              HasSubstr("resolution: is missing"));
  EXPECT_THAT(faultOf(replaced(kKalibr, "  distortion_model: equidistant\n", "")),
              HasSubstr("distortion_model: is missing"));
  EXPECT_THAT(faultOf(replaced(kOrb, "Camera.cx: 318.6\n", "")),
              HasSubstr("Camera.cx: is missing"));
  EXPECT_THAT(faultOf(replaced(kOwn, "  fx: 500\n", "")), HasSubstr("fx: is missing"));
  EXPECT_THAT(
      faultOf(replaced(kOrb, "Camera.fx: 517.3", "Camera.type: KannalaBrandt8\nCamera.fx: 5")),
      HasSubstr("Camera.k4: is missing"));
}

TEST(Calibration, RefusesExtrinsicsThatAreNotRigid) {
  EXPECT_THAT(faultOf(replaced(kEuroc, "-1.0", "-2.0")), HasSubstr("T_BS: is not a rigid"));
  EXPECT_THAT(faultOf(replaced(kKalibr, "  - [0.0, 1.0, 0.0, 0.0]\n", "")),
              HasSubstr("T_cam_imu: must be four rows"));
}

TEST(Calibration, RefusesAFocalLengthThatIsNotPositive) {
  EXPECT_THAT(faultOf(replaced(kOwn, "fx: 500", "fx: 0")), HasSubstr("fx must be positive"));
}

TEST(Calibration, NamesTheLineOfBrokenYaml) {
  EXPECT_THAT(faultOf("camera:\n  fx: [1, 2\n"), HasSubstr("glide_calibration_test.yaml:"));
  EXPECT_THAT(faultOf("just a sentence\n"), HasSubstr("is not a YAML map"));
  EXPECT_THAT(faultOf("answer: 42\n"), HasSubstr("is no calibration"));
}

TEST(Calibration, RefusesANameThatIsNeitherFileNorPreset) {
  const auto calibration = loadCalibration("freiburg9");
  ASSERT_FALSE(calibration.ok());
  EXPECT_THAT(calibration.error().message, HasSubstr("freiburg9: is neither"));
}

}  // namespace
}  // namespace glide::replay
