#include "support/shader_variants.h"

#include "gpu/compute_program.h"
#include "gpu/gl.h"
#include "gpu/gl_test.h"
#include "gpu/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dlfcn.h>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

/// Run by ctest's gpu_test_limits, which preloads libglide_gl_limits.so: the same tests on a device
/// with the least that OpenGL ES 3.1 allows. These show that it is one.
class UnderGlLimits : public GlTest {
 protected:
  void SetUp() override {
    ASSERT_NE(dlsym(RTLD_DEFAULT, "glideGlLimits"), nullptr)
        << "libglide_gl_limits.so is not there";
    GlTest::SetUp();
  }
};

/// What keeps a program with this body, and these declarations before it, from being built.
std::string refusal(const std::string& declarations, const std::string& body) {
  const Result<ComputeProgram> program = ComputeProgram::compile(
      "limits", "#version 310 es\n" + declarations + "\nvoid main() {\n" + body + "\n}\n");
  return program.ok() ? std::string() : program.error().message;
}

std::string groupOf(int x, int y) {
  return "layout(local_size_x = " + std::to_string(x) + ", local_size_y = " + std::to_string(y) +
         ") in;\nlayout(std430, binding = 0) buffer Out { uint value; };\n";
}

std::string sharedWords(int words) {
  return groupOf(1, 1) + "shared uint words[" + std::to_string(words) + "];\n";
}

constexpr const char* kUseWords = "words[value] = value; barrier(); value = words[value + 1u];";

TEST_F(UnderGlLimits, CapsAreTheFloors) {
  EXPECT_EQ(caps().es_version, (std::array<int, 2>{3, 1}));
  EXPECT_EQ(caps().max_group_invocations, 128);
  EXPECT_EQ(caps().max_shared_bytes, 16384);
  EXPECT_EQ(caps().max_storage_blocks, 4);
  EXPECT_EQ(caps().max_texture_size, 2048);
  EXPECT_EQ(caps().max_storage_bytes, 1 << 27);
  EXPECT_FALSE(caps().has_timer_query);
  EXPECT_TRUE(caps().has_external);
  EXPECT_FALSE(caps().has_external_essl3);
}

TEST_F(UnderGlLimits, AGroupHas128Invocations) {
  EXPECT_EQ(refusal(groupOf(16, 8), "value = 1u;"), "");
  EXPECT_THAT(refusal(groupOf(16, 16), "value = 1u;"), HasSubstr("256 invocations"));
}

TEST_F(UnderGlLimits, AGroupHas16KibOfSharedMemory) {
  EXPECT_EQ(refusal(sharedWords(4096), kUseWords), "");
  EXPECT_THAT(refusal(sharedWords(4097), kUseWords), HasSubstr("16384 bytes of shared memory"));
}

TEST_F(UnderGlLimits, AProgramHasFourStorageBlocks) {
  std::string blocks = groupOf(1, 1);
  std::string sum = "value = 0u";
  for (int i = 1; i < 5; ++i) {
    EXPECT_EQ(refusal(blocks, sum + ";"), "");
    const std::string n = std::to_string(i);
    blocks += "layout(std430) readonly buffer In" + n + " { uint in" + n + "; };\n";
    sum += " + in" + n;
  }
  EXPECT_THAT(refusal(blocks, sum + ";"), HasSubstr("5 storage blocks (of 4)"));
}

TEST_F(UnderGlLimits, AProgramHasFourImages) {
  const auto refusalOf = [](int count) {
    const std::string images = std::to_string(count);
    const std::string last = std::to_string(count - 1);
    return refusal(
        groupOf(1, 1) + "layout(r32f) writeonly uniform highp image2D image[" + images + "];",
        "imageStore(image[" + last + "], ivec2(0), vec4(1)); value = 1u;");
  };
  EXPECT_EQ(refusalOf(4), "");
  EXPECT_THAT(refusalOf(5), HasSubstr("5 image uniforms (of 4)"));
}

bool isCompute(const ShaderVariant& variant) {
  return variant.shader.substr(variant.shader.size() - 5) == ".comp";
}

bool needsExternalTextures(const ShaderVariant& variant) {
  return variantName(variant).find("EXTERNAL_TEXTURE=1") != std::string::npos;
}

TEST_F(UnderGlLimits, EveryKernelOfTheLibraryFits) {
  int built = 0;
  for (const ShaderVariant& variant : shaderVariants()) {
    if (!isCompute(variant) || (needsExternalTextures(variant) && !caps().has_external_essl3)) {
      continue;
    }
    const Result<std::string> text =
        assembleShader(embeddedShaders(), variant.shader, variant.defines);
    ASSERT_TRUE(text.ok());
    const Result<ComputeProgram> program = ComputeProgram::compile(variantName(variant), *text);
    EXPECT_TRUE(program.ok()) << program.error().message;
    ++built;
  }
  EXPECT_GT(built, 50);
}

TEST_F(UnderGlLimits, BindingsAndSizesBeyondTheFloorsAreErrors) {
  const auto error = [] { return glGetError(); };
  const auto invalid = static_cast<GLenum>(GL_INVALID_VALUE);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, 0);
  EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, 0);
  EXPECT_EQ(error(), invalid);
  glBindImageTexture(4, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32F);
  EXPECT_EQ(error(), invalid);
  glDispatchCompute(65536, 1, 1);
  EXPECT_NE(error(), static_cast<GLenum>(GL_NO_ERROR));
  forgetDriverMessages();
}

}  // namespace
}  // namespace glide::test
