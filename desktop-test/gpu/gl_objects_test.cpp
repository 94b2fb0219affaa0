#include "gpu/gl_objects.h"

#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::test {
namespace {

class GlObjectsTest : public GlTest {};

TEST_F(GlObjectsTest, BufferGivesBackWhatWasWritten) {
  const std::vector<float> values{1.0F, -2.5F, 3.25F};
  EXPECT_EQ(readBuffer<float>(makeBuffer(values)), values);
}

TEST_F(GlObjectsTest, MovedFromObjectOwnsNothing) {
  GlBuffer first = GlBuffer::allocate(16, GL_DYNAMIC_DRAW);
  const GLuint name = first.get();
  {
    const GlBuffer second = std::move(first);
    EXPECT_EQ(second.get(), name);
    EXPECT_EQ(first.get(), 0U);  // NOLINT(bugprone-use-after-move)
    EXPECT_TRUE(glIsBuffer(name));
  }
  EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GlObjectsTest, AbandonedNameIsNotDeleted) {
  GLuint name = 0;
  {
    GlTexture texture = GlTexture::allocate(GL_R32F, 4, 4);
    name = texture.get();
    texture.abandon();
  }
  EXPECT_TRUE(glIsTexture(name));
  glDeleteTextures(1, &name);
}

TEST_F(GlObjectsTest, BufferWithoutMemoryIsNotComplete) {
  constexpr std::int64_t kTooMuch = std::int64_t{1} << 46;
  EXPECT_FALSE(GlBuffer::allocate(kTooMuch, GL_DYNAMIC_DRAW).isComplete());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
  forgetDriverMessages();
  EXPECT_TRUE(GlBuffer::allocate(16, GL_DYNAMIC_DRAW).isComplete());
  EXPECT_TRUE(GlTexture::allocate(GL_R32F, 4, 4).isComplete());
}

TEST_F(GlObjectsTest, FenceIsReached) {
  const GlSync fence = GlSync::insert();
  EXPECT_TRUE(fence.wait(1'000'000'000));
}

}  // namespace
}  // namespace glide::test
