#pragma once

#include "gpu/gl.h"
#include "gpu/scoped_state.h"

#include <array>

namespace glide {

/// The GL state that a pass which draws one triangle into a texture touches, on top of
/// GlComputeState; docs/gl-contract.md lists the same. The fields' defaults are the initial values
/// of OpenGL ES. The pass binds its own framebuffer and vertex array and sets the viewport.
struct GlDrawState {
  GLint draw_framebuffer = 0, read_framebuffer = 0;
  GLint vertex_array = 0, array_buffer = 0;
  std::array<GLint, 4> viewport{};
  std::array<GLboolean, 4> color_mask{GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};  ///< of draw buffer 0
  bool blend = false;                                                       ///< of draw buffer 0
  bool depth_test = false, stencil_test = false, scissor_test = false, cull_face = false;
  bool rasterizer_discard = false, dither = true;
  bool sample_coverage = false, sample_alpha_to_coverage = false, sample_mask = false;

  static GlDrawState current();
  /// The viewport stays: a new context has that of its surface, which is not known here.
  static GlDrawState initial();
  void apply() const;
  /// Nothing that keeps fragments from being written as they are.
  static void neutralize();
};

/// Inside of a ScopedGlState, around a pass that draws.
using ScopedDrawState = ScopedState<GlDrawState>;

}  // namespace glide
