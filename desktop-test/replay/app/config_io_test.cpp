#include "replay/app/config_io.h"

#include "replay/common/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;

std::string faultOf(const Status& status) { return status ? "" : status.error().message; }

Status applyText(const std::string& text, Config& config) {
  const auto file = std::filesystem::path(testing::TempDir()) / "glide_config_test.yaml";
  EXPECT_TRUE(writeFile(file, text).ok());
  return applyConfigFile(file, config);
}

TEST(ConfigFile, TakesNestedAndDottedFieldsAndJson) {
  Config config;
  EXPECT_TRUE(applyText("direct:\n  levels: 5\ndirect.patch_size: 9\nbackend: cpu\n", config).ok());
  EXPECT_EQ(config.direct.levels, 5);
  EXPECT_EQ(config.direct.patch_size, 9);
  EXPECT_TRUE(applyText(R"({"direct": {"levels": 4}, "tracker": "indirect"})", config).ok());
  EXPECT_EQ(config.direct.levels, 4);
  EXPECT_EQ(config.tracker, TrackerMode::indirect);
}

TEST(ConfigFile, NamesFileLineAndField) {
  Config config;
  EXPECT_THAT(faultOf(applyText("direct:\n  levels: 5\n  patch: 9\n", config)),
              HasSubstr("glide_config_test.yaml:3: direct.patch: no config field"));
  EXPECT_THAT(faultOf(applyText("tracker: both\n", config)), HasSubstr(":1: tracker: 'both'"));
  EXPECT_FALSE(applyConfigFile("/no/such/file.yaml", config).ok());
}

TEST(ConfigYaml, IsReadBackUnchanged) {
  Config config;
  config.camera = {
      640, 480, 500.25, 501, 320, 240, DistortionModel::radial_tangential, {0.1, 1.0 / 3.0, 0, 0}};
  config.direct.max_rms = 1.0 / 7.0;
  config.tracker = TrackerMode::indirect;
  const std::string text = configYaml(config);
  Config again;
  const Status status = applyText(text, again);
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_EQ(configYaml(again), text);
  EXPECT_EQ(again.direct.max_rms, config.direct.max_rms);
  EXPECT_EQ(again.camera.coefficients, config.camera.coefficients);
}

TEST(ConfigYaml, LeavesOutACameraThatIsNotSet) {
  EXPECT_THAT(configYaml(Config{}), testing::Not(HasSubstr("camera")));
}

}  // namespace
}  // namespace glide::replay
