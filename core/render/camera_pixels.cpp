#include "render/camera_pixels.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glide {
namespace {

constexpr int kChannels = 3;

/// Rows without gaps: of a stride that is no whole number of pixels OpenGL knows nothing.
std::vector<std::uint8_t> packed(const Rgb& rgb) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(kChannels) * rgb.width;
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(row_bytes * rgb.height));
  for (int y = 0; y < rgb.height; ++y)
    std::copy_n(rgb.pixels + y * rgb.stride, row_bytes, rows.data() + y * row_bytes);
  return rows;
}

}  // namespace

Status CameraPixels::reserve(GLenum format, int width, int height) {
  const bool fits = texture_.get() != 0 && format == format_ && texture_.width() == width &&
                    texture_.height() == height;
  if (!fits) {
    texture_ = GlTexture::allocate(format, width, height);
    format_ = format;
    if (!texture_.isComplete()) {
      texture_ = GlTexture();
      return outOfMemory("the camera's picture");
    }
  }
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.get());
  return Unit{};
}

Status CameraPixels::upload(const Luma& luma) {
  if (Status reserved = reserve(GL_R8, luma.width, luma.height); !reserved) return reserved;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(luma.stride));
  glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, luma.width, luma.height, GL_RED, GL_UNSIGNED_BYTE, luma.pixels);
  return Unit{};
}

Status CameraPixels::upload(const Rgb& rgb) {
  if (rgb.stride % kChannels != 0) {
    const std::vector<std::uint8_t> rows = packed(rgb);
    return upload(Rgb{rows.data(), rgb.width, rgb.height, kChannels * rgb.width});
  }
  if (Status reserved = reserve(GL_RGB8, rgb.width, rgb.height); !reserved) return reserved;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(rgb.stride / kChannels));
  glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, rgb.width, rgb.height, GL_RGB, GL_UNSIGNED_BYTE, rgb.pixels);
  return Unit{};
}

}  // namespace glide
