#pragma once

#include "gpu/gl_objects.h"

#include "image/image.h"

#include "glide/frame.h"
#include "glide/result.h"

#include <array>
#include <cstdint>
#include <vector>

namespace glide::test {

/// Maps (s, t) to (u[0] s + u[1] t + u[2], v[0] s + v[1] t + v[2]).
TextureTransform affineTransform(const std::array<float, 3>& u, const std::array<float, 3>& v);

enum class AppTextureKind {
  r8,        ///< GL_TEXTURE_2D, the luma in red
  rgba8,     ///< GL_TEXTURE_2D, colours
  external,  ///< GL_TEXTURE_EXTERNAL_OES, as a camera gives: an EGLImage of an RGBA8 texture
};

/// A texture of an app, which the library is to read. Works in the current context, as an app does:
/// it changes the binding of the active texture unit.
class AppTexture {
 public:
  /// unsupported where EGL makes no image of a texture.
  static Result<AppTexture> create(AppTextureKind kind, int width, int height);

  /// Grey images; the first row of the image becomes the first of the memory.
  void write(const ImageViewU8& luma);
  /// Colours, four bytes a texel; not for r8.
  void write(const std::vector<std::uint8_t>& rgba);

  /// What the app passes to Session::update.
  Texture texture(const TextureTransform& transform) const;

 private:
  AppTextureKind kind_ = AppTextureKind::r8;
  int width_ = 0, height_ = 0;
  GlName<deleteTexture> memory_;    ///< 2-D
  GlName<deleteTexture> external_;  ///< the same memory
};

}  // namespace glide::test
