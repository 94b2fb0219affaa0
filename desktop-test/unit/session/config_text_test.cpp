#include "glide/config_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace glide {
namespace {

using ::testing::HasSubstr;

std::string settingFault(const char* setting) {
  Config config;
  const Status status = applySetting(config, setting);
  return status.ok() ? "no fault" : status.error().message;
}

TEST(Setting, ReachesFieldsOfEveryType) {
  Config config;
  for (const char* setting : {"direct.patch_size=7",
                              "direct.max_rms=12.5",
                              "backend=cpu",
                              "execution=inline",
                              "camera.coefficients=[0.1, -0.2,0,0]"}) {
    EXPECT_TRUE(applySetting(config, setting).ok()) << setting;
  }
  EXPECT_EQ(config.direct.patch_size, 7);
  EXPECT_EQ(config.direct.max_rms, 12.5);
  EXPECT_EQ(config.backend, Backend::cpu);
  EXPECT_EQ(config.execution, Execution::inline_);
  EXPECT_THAT(config.camera.coefficients, testing::ElementsAre(0.1, -0.2, 0, 0));
}

TEST(Setting, SaysWhatIsWrong) {
  EXPECT_THAT(settingFault("direct.patch_size"), HasSubstr("name=value"));
  EXPECT_THAT(settingFault("direct.patchsize=7"), HasSubstr("did you mean direct.patch_size?"));
  EXPECT_THAT(settingFault("patch_size=7"), HasSubstr("did you mean direct.patch_size?"));
  EXPECT_THAT(settingFault("colour=red"), HasSubstr("--print-config"));
  EXPECT_THAT(settingFault("direct.patch_size=7.5"), HasSubstr("not a whole number"));
  EXPECT_THAT(settingFault("direct.max_rms=low"), HasSubstr("'low' is not a number"));
  EXPECT_THAT(settingFault("backend=gpu"), HasSubstr("none of auto, gles, cpu"));
}

TEST(Setting, NamesTheFieldInFront) {
  EXPECT_THAT(settingFault("direct.max_rms=low"), HasSubstr("direct.max_rms: "));
}

TEST(Setting, ChangesNothingWhenAListIsWrong) {
  Config config;
  config.camera.coefficients = {1.0};
  EXPECT_FALSE(setField(config, "camera.coefficients", "0.1 x").ok());
  EXPECT_THAT(config.camera.coefficients, testing::ElementsAre(1.0));
}

}  // namespace
}  // namespace glide
