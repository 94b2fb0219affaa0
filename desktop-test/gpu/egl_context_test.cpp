#include "support/egl_context.h"

#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace glide::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Run by ctest in an environment that hides every EGL driver.
TEST(EglContextWithoutDriver, SaysWhatEachPlatformAnswered) {
  if (std::getenv("GLIDE_NO_DRIVER") == nullptr) {
    GTEST_SKIP()
        << "no device needed; runs in ctest's gpu_test_without_driver, which hides the drivers";
  }
  const Result<EglContext> context = EglContext::create(EglDebug::off);
  ASSERT_FALSE(context.ok());
  EXPECT_EQ(context.error().code, ErrorCode::unsupported);
  EXPECT_THAT(context.error().message,
              AllOf(HasSubstr("no OpenGL ES 3.1 context"), HasSubstr("default: no display")));
}

class EglContextTest : public GlTest {};

TEST_F(EglContextTest, MakesTheContextCurrentWithoutASurface) {
  EXPECT_GE(caps().es_version, (std::array<int, 2>{3, 1}));
  GLint framebuffer = -1;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  EXPECT_EQ(framebuffer, 0);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER),
            static_cast<GLenum>(GL_FRAMEBUFFER_UNDEFINED));
}

}  // namespace
}  // namespace glide::test
