#include "render/scene_buffer.h"

#include "gpu/gl_state.h"
#include "gpu/gl_test.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

class SceneBufferTest : public GlTest {
 protected:
  static std::vector<int> contents(const SceneBuffer& buffer, std::size_t count) {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.get());
    const auto bytes = static_cast<GLsizeiptr>(count * sizeof(int));
    const void* mapped = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    const auto* values = static_cast<const int*>(mapped);
    const std::vector<int> copy(values, values + count);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return copy;
  }
};

TEST_F(SceneBufferTest, TakesOnlyWhatHasChanged) {
  SceneArray<int> array;
  SceneBuffer buffer;
  array.assign({1, 2, 3});
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(buffer.uploadedBytes(), 12);
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(buffer.uploadedBytes(), 12);
  array.append(4);
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(buffer.uploadedBytes(), 16);
  array.assign({1, 2, 7, 8});
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(buffer.uploadedBytes(), 24);
  EXPECT_EQ(contents(buffer, 4), array.items());
}

TEST_F(SceneBufferTest, GrowsAndKeepsWhatItHas) {
  SceneArray<int> array;
  SceneBuffer buffer;
  for (int i = 0; i < 5000; ++i) {
    array.append(i);
    if (i % 500 != 0) continue;
    ASSERT_TRUE(buffer.update(&array));
  }
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(contents(buffer, 5000), array.items());
  // Doubling: no item was uploaded more than a few times.
  EXPECT_LT(buffer.uploadedBytes(), 4 * 5000 * static_cast<std::int64_t>(sizeof(int)));
}

TEST_F(SceneBufferTest, TakesAllAgainWhenItsNameIsLost) {
  SceneArray<int> array;
  array.assign({1, 2, 3});
  {
    SceneBuffer lost;
    ASSERT_TRUE(lost.update(&array));
  }
  array.markLost();
  SceneBuffer buffer;
  ASSERT_TRUE(buffer.update(&array));
  EXPECT_EQ(contents(buffer, 3), array.items());
}

}  // namespace
}  // namespace glide::test
