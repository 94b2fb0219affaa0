#include "gpu/gl_caps.h"

#include "gpu/gl_test.h"

#include <EGL/egl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

TEST(GlVersion, IsReadFromOpenGlEsStringsOnly) {
  EXPECT_EQ(parseEsVersion("OpenGL ES 3.2 Mesa 22.3.6"), (std::array<int, 2>{3, 2}));
  EXPECT_EQ(parseEsVersion("OpenGL ES 3.1 v1.r26p0-01eac0"), (std::array<int, 2>{3, 1}));
  EXPECT_EQ(parseEsVersion("OpenGL ES 2.0 (ANGLE 2.1)"), (std::array<int, 2>{2, 0}));
  EXPECT_EQ(parseEsVersion("OpenGL ES-CM 1.1 Mesa 22.3.6"), std::nullopt);
  EXPECT_EQ(parseEsVersion("4.5 (Core Profile) Mesa 22.3.6"), std::nullopt);
  EXPECT_EQ(parseEsVersion("OpenGL ES "), std::nullopt);
  EXPECT_EQ(parseEsVersion(""), std::nullopt);
}

TEST(GlCapsWithoutContext, AreMissingWithAReason) {
  Result<GlCaps> caps = Error{};
  // A context is current per thread: a new thread has none.
  std::thread([&] { caps = GlCaps::query(); }).join();
  ASSERT_FALSE(caps.ok());
  EXPECT_EQ(caps.error().code, ErrorCode::missing_context);
  EXPECT_THAT(caps.error().message, HasSubstr("no context is current"));
}

class GlCapsTest : public GlTest {};

TEST_F(GlCapsTest, ReachTheMinimaOfEs31) {
  EXPECT_GE(caps().es_version, (std::array<int, 2>{3, 1}));
  EXPECT_GE(caps().max_group_invocations, 128);
  EXPECT_GE(caps().max_shared_bytes, 16384);
  EXPECT_GE(caps().max_storage_blocks, 4);
  EXPECT_GE(caps().max_storage_bytes, std::int64_t{1} << 27);
  EXPECT_FALSE(caps().vendor.empty());
  EXPECT_FALSE(caps().renderer.empty());
}

/// What GlCaps::query says on a thread where a context of another kind is current.
Result<GlCaps> queryOtherContext(EGLenum api, int major) {
  Result<GlCaps> caps = Error{ErrorCode::internal, "not made"};
  const EGLDisplay display = eglGetCurrentDisplay();
  std::thread([&] {
    eglBindAPI(api);
    const EGLint bits = api == EGL_OPENGL_API ? EGL_OPENGL_BIT : EGL_OPENGL_ES_BIT;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, bits, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) == EGL_FALSE || count == 0) return;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, major, EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT) return;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
      caps = GlCaps::query();
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }).join();
  return caps;
}

TEST_F(GlCapsTest, NameTheContextThatIsTooOldOrNotEs) {
  for (const Result<GlCaps>& caps :
       {queryOtherContext(EGL_OPENGL_ES_API, 1), queryOtherContext(EGL_OPENGL_API, 3)}) {
    ASSERT_FALSE(caps.ok());
    if (caps.error().message == "not made") continue;  // the driver has no such context
    EXPECT_EQ(caps.error().code, ErrorCode::unsupported);
    EXPECT_THAT(caps.error().message, HasSubstr("OpenGL ES 3.1 is needed"));
  }
}

}  // namespace
}  // namespace glide::test
