// Every variant of every shader that the library can build passes glslangValidator.
#include "support/shader_variants.h"

#include "gpu/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <unistd.h>

namespace glide::test {
namespace {

namespace fs = std::filesystem;

/// Writes all variants into `folder`; returns the paths for a command line, by shader.
std::map<std::string_view, std::string> writeVariants(const fs::path& folder) {
  std::map<std::string_view, std::string> paths;
  int index = 0;
  for (const ShaderVariant& variant : shaderVariants()) {
    const Result<std::string> text =
        assembleShader(embeddedShaders(), variant.shader, variant.defines);
    if (!text) {
      ADD_FAILURE() << text.error().message;
      continue;
    }
    const fs::path path = folder / (std::to_string(index++) + "_" + std::string(variant.shader));
    std::ofstream(path) << *text;
    paths[variant.shader] += " '" + path.string() + "'";
  }
  return paths;
}

TEST(ShaderVariants, AreListedForEveryShaderOfTheLibrary) {
  EXPECT_THAT(missingVariants(embeddedShaders()), ::testing::IsEmpty());
}

TEST(ShaderVariants, MissAShaderThatIsNew) {
  const EmbeddedShader added[] = {{"new.frag", ""}, {"new.glsl", ""}};
  EXPECT_THAT(missingVariants(added), ::testing::Contains("new.frag has no variants"));
  EXPECT_THAT(missingVariants(added),
              ::testing::Contains("align_solve.comp is listed but not there"));
}

TEST(ShaderVariants, PassGlslangValidator) {
  const char* validator = std::getenv("GLSLANG_VALIDATOR");
  if (validator == nullptr || !fs::exists(validator)) {
    GTEST_SKIP() << "no device needed; glslangValidator (package glslang-tools) is not installed";
  }
  const fs::path folder =
      fs::temp_directory_path() / ("glide_shaders_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const auto& [shader, paths] : writeVariants(folder)) {
    const fs::path log = folder / "log.txt";
    const std::string command = std::string(validator) + paths + " > '" + log.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << shader << "\n" << std::ifstream(log).rdbuf();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace glide::test
