#include "glide/config.h"

#include "glide/config_fields.h"
#include "glide/enum_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <type_traits>

namespace glide {
namespace {

using ::testing::HasSubstr;

Config validConfig() {
  Config config;
  config.camera = {640, 480, 500.0, 500.0, 319.5, 239.5, DistortionModel::none, {}};
  return config;
}

std::string faultOf(const Config& config) {
  const Status status = validate(config);
  return status ? "" : status.error().message;
}

/// Puts `value` into the number field called `name`.
struct SetNumber {
  std::string name;
  double value;
  template <class T>
  void operator()(const FieldInfo& field, T& target) {
    if constexpr (std::is_arithmetic_v<T>) {
      if (field.name == name) target = static_cast<T>(value);
    }
  }
};

struct Range {
  double min, max;
};

/// All number fields of the table but the camera's.
std::map<std::string, Range> numberFields() {
  std::map<std::string, Range> fields;
  const Config config;
  forEachField(config, [&](const FieldInfo& field, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if (std::is_arithmetic_v<T> && field.name.rfind("camera.", 0) != 0) {
      fields[std::string(field.name)] = {field.min, field.max};
    }
  });
  return fields;
}

/// The number fields of config.h with the ranges that their comments state, on the same line or
/// the next.
std::map<std::string, Range> fieldsOfHeader(std::istream& header) {
  const std::regex open(R"(\s*struct (\w+) \{)");
  const std::regex close(R"(\s*\} (\w+);)");
  const std::regex field(R"(\s*(?:int|double) (\w+) =.*)");
  const std::regex range(R"(.*?([-+.\de]+)\.\.([-+.\de]+)\s*)");
  std::map<std::string, Range> pending, fields;
  std::string name;
  std::smatch match;
  for (std::string line; std::getline(header, line);) {
    if (std::regex_match(line, match, open)) pending.clear();
    if (std::regex_match(line, match, field)) name = match[1];
    if (!name.empty() && std::regex_match(line, match, range)) {
      pending[name] = {std::stod(match[1]), std::stod(match[2])};
      name.clear();
    }
    if (!std::regex_match(line, match, close)) continue;
    for (const auto& [leaf, bounds] : pending) fields[match[1].str() + "." + leaf] = bounds;
  }
  return fields;
}

TEST(Config, AcceptsItsOwnDefaultsWithACamera) { EXPECT_EQ(faultOf(validConfig()), ""); }

TEST(Config, RefusesAMissingCamera) { EXPECT_THAT(faultOf(Config{}), HasSubstr("camera.width")); }

TEST(Config, NamesEachFieldThatIsOutsideItsRangeWithItsRange) {
  for (const auto& [name, range] : numberFields()) {
    for (const double value : {range.min - 1.0, range.max + 1.0}) {
      Config config = validConfig();
      forEachField(config, SetNumber{name, value});
      EXPECT_THAT(faultOf(config), HasSubstr(name + " = ")) << value;
    }
  }
}

TEST(Config, RefusesNotANumber) {
  Config config = validConfig();
  config.direct.max_rms = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(faultOf(config), HasSubstr("direct.max_rms"));
}

TEST(Config, RefusesAnEnumNumberThatHasNoName) {
  Config config = validConfig();
  config.backend = static_cast<Backend>(17);
  EXPECT_THAT(faultOf(config), HasSubstr("backend"));
}

TEST(Config, RefusesAnEvenPatch) {
  Config config = validConfig();
  config.direct.patch_size = 8;
  EXPECT_THAT(faultOf(config), HasSubstr("direct.patch_size must be odd"));
}

TEST(Config, RefusesBoundsThatContradictEachOther) {
  Config config = validConfig();
  config.keyframes.min_interval = 40;
  EXPECT_THAT(faultOf(config), HasSubstr("keyframes.min_interval"));
  config = validConfig();
  config.features.fast_threshold_low = 30;
  EXPECT_THAT(faultOf(config), HasSubstr("features.fast_threshold_low"));
}

TEST(Config, RefusesAWrongNumberOfDistortionCoefficients) {
  Config config = validConfig();
  config.camera.distortion = DistortionModel::kannala_brandt4;
  config.camera.coefficients = {0.1, 0.2};
  EXPECT_NE(faultOf(config), "");
}

TEST(ConfigFields, AreTheFieldsOfTheHeaderWithTheRangesOfItsComments) {
  const char* source = std::getenv("GLIDE_SOURCE_DIR");
  if (source == nullptr) GTEST_SKIP() << "GLIDE_SOURCE_DIR is not set: run this test with ctest";
  std::ifstream header(std::filesystem::path(source) / "core/include/glide/config.h");
  std::map<std::string, Range> expected = fieldsOfHeader(header);
  ASSERT_GT(expected.size(), 30u);
  for (const auto& [name, range] : numberFields()) {
    ASSERT_EQ(expected.count(name), 1u) << name << " is not in config.h with a range";
    EXPECT_DOUBLE_EQ(range.min, expected[name].min) << name;
    EXPECT_DOUBLE_EQ(range.max, expected[name].max) << name;
    expected.erase(name);
  }
  for (const auto& [name, range] : expected) ADD_FAILURE() << name << " is not in the table";
}

TEST(ConfigFields, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  const Config config;
  forEachField(config, [&](const FieldInfo& field, const auto&) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  });
}

TEST(EnumNames, GoThereAndBack) {
  EXPECT_EQ(enumName(Backend::automatic), "auto");
  EXPECT_EQ(enumFromName<Execution>("inline"), std::optional(Execution::inline_));
  EXPECT_EQ(enumFromName<Backend>("gpu"), std::nullopt);
  for (const auto& entry : enumNames(SwitchReason{})) {
    EXPECT_EQ(enumFromName<SwitchReason>(entry.name), std::optional(entry.value));
  }
}

}  // namespace
}  // namespace glide
