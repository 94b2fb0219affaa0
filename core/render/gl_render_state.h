#pragma once

#include "gpu/gl.h"
#include "gpu/scoped_state.h"

#include <array>

namespace glide {

/// The GL state that drawing into the app's framebuffer touches on top of GlDrawState;
/// docs/gl-contract.md lists the same. The fields' defaults are the initial values of OpenGL ES.
struct GlRenderState {
  std::array<GLint, 4> scissor_box{};
  std::array<GLint, 4> blend_factors{GL_ONE, GL_ZERO, GL_ONE, GL_ZERO};  ///< of draw buffer 0
  GLint depth_function = GL_LESS;
  GLboolean depth_mask = GL_TRUE;
  std::array<GLfloat, 2> depth_range{0.0F, 1.0F};
  GLfloat depth_clear = 1.0F;
  bool polygon_offset = false;

  static GlRenderState current();
  /// The scissor box stays: a new context has that of its surface, which is not known here.
  static GlRenderState initial();
  void apply() const;
  /// Blending by alpha, depths as OpenGL has them at first but for GL_LEQUAL.
  static void neutralize();
};

/// Inside of a ScopedDrawState, around what draws into the app's framebuffer.
using ScopedRenderState = ScopedState<GlRenderState>;

}  // namespace glide
