#include "gpu/shader_source.h"

#include "gpu/compute_program.h"
#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

TEST(ShaderSource, PutsDefinesAfterTheVersionAndResolvesIncludes) {
  const EmbeddedShader library[] = {
      {"main.comp", "#version 310 es\n#include \"a.glsl\"\nvoid main() {}\n"},
      {"a.glsl", "#include \"b.glsl\"\nint a;\n"},
      {"b.glsl", "int b;"}};
  const Result<std::string> text = assembleShader(library, "main.comp", {{"N", 7}, {"M", -1}});
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(*text, "#version 310 es\n#define N 7\n#define M -1\nint b;\nint a;\nvoid main() {}\n");
}

TEST(ShaderSource, NamesAMissingFile) {
  const EmbeddedShader library[] = {{"main.comp", "#version 310 es\n#include \"gone.glsl\"\n"}};
  const Result<std::string> text = assembleShader(library, "main.comp", {});
  ASSERT_FALSE(text.ok());
  EXPECT_THAT(text.error().message, HasSubstr("gone.glsl"));
}

TEST(ShaderSource, RefusesACycleOfIncludes) {
  const EmbeddedShader library[] = {{"a.glsl", "#include \"a.glsl\"\n"}};
  EXPECT_FALSE(assembleShader(library, "a.glsl", {}).ok());
}

class ComputeProgramTest : public GlTest {};

TEST_F(ComputeProgramTest, GivesTheDriversLogWhenAShaderDoesNotCompile) {
  const Result<ComputeProgram> program =
      ComputeProgram::compile("broken.comp", "#version 310 es\nvoid main() { nonsense; }\n");
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().code, ErrorCode::gl);
  EXPECT_THAT(program.error().message, HasSubstr("broken.comp"));
  EXPECT_THAT(program.error().message, HasSubstr("nonsense"));
  forgetDriverMessages();
}

}  // namespace
}  // namespace glide::test
