#pragma once

#include "gpu/gl.h"
#include "gpu/scoped_state.h"

namespace glide {

/// The GL state that a RenderTarget touches on top of GlRasterState: what framebuffers and
/// renderbuffers are bound to, and where glReadPixels puts rows. The fields' defaults are the
/// initial values of OpenGL ES.
struct GlTargetState {
  GLint draw_framebuffer = 0, read_framebuffer = 0, renderbuffer = 0;
  GLint pack_buffer = 0, pack_alignment = 4;
  GLint pack_row_length = 0, pack_skip_rows = 0, pack_skip_pixels = 0;

  static GlTargetState current();
  static GlTargetState initial() { return {}; }
  void apply() const;
  /// Pixels go to memory, rows without gaps.
  static void neutralize();
};

}  // namespace glide
