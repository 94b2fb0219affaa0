#pragma once

#include "gpu/gl_caps.h"
#include "gpu/gl_objects.h"

#include "image/image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace glide::test {

/// Invocations per workgroup that every shader is tested with.
inline constexpr int kGroupSizes[] = {32, 64, 128};

/// Fixture of all tests that need OpenGL ES 3.1: one context for the program, with KHR_debug. Skips
/// with device and reason where there is none (fails when GLIDE_REQUIRE_GL=1), and fails when the
/// driver reported an error during the test.
class GlTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  const GlCaps& caps() const { return caps_; }
  /// For tests that provoke an error: what the driver has said so far does not count.
  static void forgetDriverMessages();
  /// softpipe is about 50 times slower than llvmpipe: tests take smaller images there.
  bool isSlow() const { return caps_.renderer.find("softpipe") != std::string::npos; }
  int imageWidth() const { return isSlow() ? 160 : 376; }
  int imageHeight() const { return isSlow() ? 120 : 240; }
  int pointCount() const { return isSlow() ? 60 : 200; }

 private:
  GlCaps caps_;
};

/// Waits for the GPU and copies a buffer of T out.
template <class T>
std::vector<T> readBuffer(const GlBuffer& buffer) {
  std::vector<T> values(static_cast<std::size_t>(buffer.bytes()) / sizeof(T));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glFinish();
  EXPECT_TRUE(buffer.read(values.data(), buffer.bytes()));
  return values;
}

/// A buffer that holds `values`.
template <class T>
GlBuffer makeBuffer(const std::vector<T>& values) {
  const auto bytes = static_cast<std::int64_t>(values.size() * sizeof(T));
  GlBuffer buffer = GlBuffer::allocate(bytes, GL_DYNAMIC_DRAW);
  buffer.write(values.data(), bytes);
  return buffer;
}

/// Waits for the GPU and copies an r32f texture out.
ImageF readTexture(const GlTexture& texture);

/// Seeded white noise; the view of the image has its own stride.
ImageU8 randomImage(int width, int height, std::uint32_t seed);

}  // namespace glide::test
