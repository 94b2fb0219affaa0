#include "support/app_texture.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstddef>
#include <utility>

namespace glide::test {
namespace {

GlName<deleteTexture> makeMemory(GLenum format, int width, int height) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  return GlName<deleteTexture>(name);
}

/// An external texture that shows the memory of a 2-D one; name 0 when EGL cannot do that.
GlName<deleteTexture> makeExternal(GLuint memory) {
  const auto create_image =
      reinterpret_cast<PFNEGLCREATEIMAGEKHRPROC>(eglGetProcAddress("eglCreateImageKHR"));
  const auto destroy_image =
      reinterpret_cast<PFNEGLDESTROYIMAGEKHRPROC>(eglGetProcAddress("eglDestroyImageKHR"));
  const auto target_texture = reinterpret_cast<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>(
      eglGetProcAddress("glEGLImageTargetTexture2DOES"));
  if (create_image == nullptr || destroy_image == nullptr || target_texture == nullptr) return {};
  const EGLDisplay display = eglGetCurrentDisplay();
  const EGLImageKHR image =
      create_image(display,
                   eglGetCurrentContext(),
                   EGL_GL_TEXTURE_2D_KHR,
                   reinterpret_cast<EGLClientBuffer>(static_cast<std::uintptr_t>(memory)),
                   nullptr);
  if (image == EGL_NO_IMAGE_KHR) return {};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, name);
  target_texture(GL_TEXTURE_EXTERNAL_OES, image);
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, 0);
  destroy_image(display, image);
  return GlName<deleteTexture>(name);
}

/// The rows of an app's upload have no gaps.
void upload(GLuint texture, GLenum format, int width, int height, const std::uint8_t* texels) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, GL_UNSIGNED_BYTE, texels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

}  // namespace

TextureTransform affineTransform(const std::array<float, 3>& u, const std::array<float, 3>& v) {
  TextureTransform m = kLowerRowFirst;
  for (std::size_t i : {0U, 1U}) {
    m[4 * i] = u[i];
    m[4 * i + 1] = v[i];
  }
  m[12] = u[2];
  m[13] = v[2];
  return m;
}

Result<AppTexture> AppTexture::create(AppTextureKind kind, int width, int height) {
  AppTexture made;
  made.kind_ = kind;
  made.width_ = width;
  made.height_ = height;
  made.memory_ = makeMemory(kind == AppTextureKind::r8 ? GL_R8 : GL_RGBA8, width, height);
  if (kind != AppTextureKind::external) return made;
  made.external_ = makeExternal(made.memory_.get());
  if (made.external_.get() == 0)
    return Error{ErrorCode::unsupported, "EGL makes no image of a texture here"};
  return made;
}

void AppTexture::write(const ImageViewU8& luma) {
  const std::size_t channels = kind_ == AppTextureKind::r8 ? 1 : 4;
  std::vector<std::uint8_t> texels;
  texels.reserve(channels * static_cast<std::size_t>(width_ * height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) texels.insert(texels.end(), channels, luma.at(x, y));
  }
  const GLenum format = kind_ == AppTextureKind::r8 ? GL_RED : GL_RGBA;
  upload(memory_.get(), format, width_, height_, texels.data());
}

void AppTexture::write(const std::vector<std::uint8_t>& rgba) {
  upload(memory_.get(), GL_RGBA, width_, height_, rgba.data());
}

Texture AppTexture::texture(const TextureTransform& transform) const {
  const bool is_external = kind_ == AppTextureKind::external;
  return {is_external ? external_.get() : memory_.get(),
          static_cast<std::uint32_t>(is_external ? GL_TEXTURE_EXTERNAL_OES : GL_TEXTURE_2D),
          width_,
          height_,
          transform};
}

}  // namespace glide::test
