#pragma once

#include "gpu/gl_objects.h"

#include "glide/render_types.h"

namespace glide {

/// Pixels of the caller in a texture of ours, made anew only when the size or kind changes. Inside
/// of a ScopedGlState; leaves the texture bound to GL_TEXTURE_2D of unit 0 and the unpack state
/// changed.
class CameraPixels {
 public:
  /// One upload. gl when there is no memory. The pictures passed checkPicture.
  Status upload(const Luma& luma);
  Status upload(const Rgb& rgb);
  void abandon() { texture_.abandon(); }

 private:
  Status reserve(GLenum format, int width, int height);

  GlTexture texture_;
  GLenum format_ = GL_NONE;
};

}  // namespace glide
