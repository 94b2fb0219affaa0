#pragma once

#include "gpu/gl_raster_state.h"

namespace glide {

/// The GL state that a pass which draws one triangle into a texture touches, on top of
/// GlComputeState; docs/gl-contract.md lists the same. The pass binds
/// its own framebuffer.
struct GlDrawState {
  GLint draw_framebuffer = 0, read_framebuffer = 0;
  GlRasterState raster;

  static GlDrawState current();
  static GlDrawState initial();
  void apply() const;
  /// Nothing that keeps fragments from being written as they are.
  static void neutralize();
};

/// Inside of a ScopedGlState, around a pass that draws.
using ScopedDrawState = ScopedState<GlDrawState>;

}  // namespace glide
