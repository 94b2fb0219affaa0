// Every variant of every shader that the library can build passes glslangValidator.
#include "gpu/gl_test.h"
#include "gpu/shader_source.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace glide::test {
namespace {

namespace fs = std::filesystem;

/// All combinations of the defines that are injected; a shader ignores those it does not know.
std::vector<ShaderDefines> variants() {
  constexpr int kPatchSizes[] = {7, 11};
  constexpr int kCameraModels = 3;
  constexpr int kCount =
      static_cast<int>(std::size(kGroupSizes) * std::size(kPatchSizes)) * kCameraModels;
  std::vector<ShaderDefines> all;
  for (int i = 0; i < kCount; ++i) {
    const int group_size = kGroupSizes[i / (kCameraModels * 2)];
    all.push_back({{"GROUP_SIZE", group_size},
                   {"GROUP_ROWS", group_size / 32},
                   {"PATCH_SIZE", kPatchSizes[i / kCameraModels % 2]},
                   {"CAMERA_MODEL", i % kCameraModels},
                   {"STRIP_ROWS", 4}});
  }
  return all;
}

bool isComputeShader(std::string_view name) {
  constexpr std::string_view kSuffix = ".comp";
  return name.size() > kSuffix.size() && name.substr(name.size() - kSuffix.size()) == kSuffix;
}

/// Writes the variants of `shader` into `folder`; returns their paths for a command line.
std::string writeVariants(const EmbeddedShader& shader, const fs::path& folder) {
  std::string paths;
  int index = 0;
  for (const ShaderDefines& defines : variants()) {
    const Result<std::string> text = assembleShader(embeddedShaders(), shader.name, defines);
    if (!text) {
      ADD_FAILURE() << text.error().message;
      continue;
    }
    const fs::path path = folder / (std::to_string(index++) + "_" + std::string(shader.name));
    std::ofstream(path) << *text;
    paths += " '" + path.string() + "'";
  }
  return paths;
}

TEST(ShaderVariants, PassGlslangValidator) {
  const char* validator = std::getenv("GLSLANG_VALIDATOR");
  if (validator == nullptr || !fs::exists(validator)) {
    GTEST_SKIP() << "no device needed; glslangValidator (package glslang-tools) is not installed";
  }
  const fs::path folder =
      fs::temp_directory_path() / ("glide_shaders_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  int count = 0;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    if (!isComputeShader(shader.name)) continue;
    const std::string paths = writeVariants(shader, folder);
    const fs::path log = folder / "log.txt";
    const std::string command = std::string(validator) + paths + " > '" + log.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << shader.name << "\n" << std::ifstream(log).rdbuf();
    ++count;
  }
  EXPECT_GE(count, 5);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace glide::test
