#include "replay/calibration/field_of_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

TEST(FieldOfView, IsToldFromFilesAndPresets) {
  EXPECT_TRUE(isFieldOfView("fov:69"));
  EXPECT_FALSE(isFieldOfView("freiburg1"));
  EXPECT_FALSE(isFieldOfView("my_fov:69.yaml"));
}

TEST(FieldOfView, GivesTheFocalLengthOfTheLongerSide) {
  const Result<Calibration> wide = calibrationOfField("fov:90", 640, 480);
  ASSERT_TRUE(wide);
  EXPECT_NEAR(wide->camera.fx, 320.0, 1e-9);
  EXPECT_EQ(wide->camera.fy, wide->camera.fx);
  EXPECT_EQ(wide->camera.cx, 319.5);
  EXPECT_EQ(wide->camera.cy, 239.5);
  EXPECT_EQ(wide->camera.width, 640);
  EXPECT_EQ(wide->camera.distortion, DistortionModel::none);
  const Result<Calibration> upright = calibrationOfField("fov:90", 480, 640);
  ASSERT_TRUE(upright);
  EXPECT_NEAR(upright->camera.fx, 320.0, 1e-9);
}

TEST(FieldOfView, RefusesWhatIsNoAngle) {
  for (const char* text : {"fov:", "fov:wide", "fov:9", "fov:151", "fov:nan", "fov:69deg"}) {
    const Result<Calibration> refused = calibrationOfField(text, 640, 480);
    ASSERT_FALSE(refused) << text;
    EXPECT_THAT(refused.error().message, ::testing::HasSubstr(text));
  }
}

}  // namespace
}  // namespace glide::replay
