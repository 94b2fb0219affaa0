#pragma once

#include "gpu/gl_objects.h"
#include "gpu/texture_placement.h"

#include "glide/config.h"

#include <array>

namespace glide {

/// The way to an external texture for devices whose compute shaders cannot sample one: draws the
/// frame that it shows into an r8 texture of the frame's size, grey levels rounded, first row first
/// (shaders/external_to_grey.frag, ESSL 1.00 with GL_OES_EGL_image_external). Framebuffer and
/// vertex array, which contexts do not share, live for one call.
class ExternalDraw {
 public:
  /// Inside of a ScopedGlState. gl when the shaders do not build or there is no memory.
  static Result<ExternalDraw> create(FrameSize frame);

  /// Draws from `texture`. Inside of a ScopedGlState; no sampler object is bound.
  void run(GLuint texture, const TexturePlacement& place, GlStatePolicy policy) const;
  const GlTexture& target() const { return target_; }
  void abandon() { abandonAll(program_, corners_, target_); }

 private:
  ExternalDraw(GlProgram program, GlBuffer corners, GlTexture target);
  void useProgram(const TexturePlacement& place) const;

  GlProgram program_;
  GlBuffer corners_;
  GlTexture target_;
  std::array<GLint, 4> uniforms_{};  ///< origin, per_column, per_row, weights
};

}  // namespace glide
