#pragma once

#include "gpu/gl.h"
#include "gpu/scoped_state.h"

#include <array>

namespace glide {

/// The GL state between vertices and fragments of draw buffer 0 that a pass which draws touches,
/// but for framebuffers. The fields' defaults are the initial values of OpenGL ES. The pass binds
/// its own vertex array and sets the viewport.
struct GlRasterState {
  GLint vertex_array = 0, array_buffer = 0;
  std::array<GLint, 4> viewport{};
  std::array<GLboolean, 4> color_mask{GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};  ///< of draw buffer 0
  bool blend = false;                                                       ///< of draw buffer 0
  /// Of draw buffer 0. One of KHR_blend_equation_advanced forbids draws with ordinary shaders, even
  /// where only another draw buffer blends.
  std::array<GLint, 2> blend_equations{GL_FUNC_ADD, GL_FUNC_ADD};
  bool depth_test = false, stencil_test = false, scissor_test = false, cull_face = false;
  bool rasterizer_discard = false, dither = true;
  bool sample_coverage = false, sample_alpha_to_coverage = false, sample_mask = false;

  static GlRasterState current();
  /// The viewport stays: a new context has that of its surface, which is not known here.
  static GlRasterState initial();
  void apply() const;
  /// Nothing that keeps fragments from being written as they are.
  static void neutralize();
};

/// Whether each draw buffer has its own blending and colour mask (OpenGL ES 3.2), which
/// glDisable(GL_BLEND), glBlendFunc and glColorMask would set for all of them.
bool hasStateOfEachDrawBuffer();

}  // namespace glide
