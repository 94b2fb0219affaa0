#include "render/gl_render_state.h"

#include "gpu/gl_query.h"
#include "gpu/gl_raster_state.h"

// ES 3.2, for the state of one draw buffer: called only in such contexts.
#include <GLES3/gl32.h>

namespace glide {
namespace {

using Factors = std::array<GLint, 4>;
using Equations = std::array<GLint, 2>;

void applyEquations(const Equations& equations) {
  const bool of_each = hasStateOfEachDrawBuffer();
  const GLenum rgb = nameOf(equations[0]);
  const GLenum alpha = nameOf(equations[1]);
  if (rgb != alpha) {
    of_each ? glBlendEquationSeparatei(0, rgb, alpha) : glBlendEquationSeparate(rgb, alpha);
  } else {  // the only functions that take an equation of KHR_blend_equation_advanced
    of_each ? glBlendEquationi(0, rgb) : glBlendEquation(rgb);
  }
}

void applyBlending(const Factors& factors, const Equations& equations) {
  const std::array<GLenum, 4> f{
      nameOf(factors[0]), nameOf(factors[1]), nameOf(factors[2]), nameOf(factors[3])};
  if (hasStateOfEachDrawBuffer()) {
    glBlendFuncSeparatei(0, f[0], f[1], f[2], f[3]);
  } else {
    glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
  }
  applyEquations(equations);
}

}  // namespace

GlRenderState GlRenderState::current() {
  GlRenderState state;
  glGetIntegerv(GL_SCISSOR_BOX, state.scissor_box.data());
  state.blend_factors = {glInteger(GL_BLEND_SRC_RGB),
                         glInteger(GL_BLEND_DST_RGB),
                         glInteger(GL_BLEND_SRC_ALPHA),
                         glInteger(GL_BLEND_DST_ALPHA)};
  state.blend_equations = {glInteger(GL_BLEND_EQUATION_RGB), glInteger(GL_BLEND_EQUATION_ALPHA)};
  state.depth_function = glInteger(GL_DEPTH_FUNC);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &state.depth_mask);
  glGetFloatv(GL_DEPTH_RANGE, state.depth_range.data());
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, &state.depth_clear);
  state.polygon_offset = glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE;
  return state;
}

GlRenderState GlRenderState::initial() {
  GlRenderState state;
  glGetIntegerv(GL_SCISSOR_BOX, state.scissor_box.data());
  return state;
}

void GlRenderState::apply() const {
  glScissor(scissor_box[0], scissor_box[1], scissor_box[2], scissor_box[3]);
  applyBlending(blend_factors, blend_equations);
  glDepthFunc(nameOf(depth_function));
  glDepthMask(depth_mask);
  glDepthRangef(depth_range[0], depth_range[1]);
  glClearDepthf(depth_clear);
  if (polygon_offset) {
    glEnable(GL_POLYGON_OFFSET_FILL);
  } else {
    glDisable(GL_POLYGON_OFFSET_FILL);
  }
}

void GlRenderState::neutralize() {
  // Alpha adds up, so that a transparent framebuffer can be laid over something else.
  applyBlending({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
                {GL_FUNC_ADD, GL_FUNC_ADD});
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDepthRangef(0.0F, 1.0F);
  glClearDepthf(1.0F);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace glide
