#include "render/gl_render_state.h"

#include "gpu/gl_query.h"
#include "gpu/gl_raster_state.h"

// ES 3.2, for the state of one draw buffer: called only in such contexts.
#include <GLES3/gl32.h>

namespace glide {
namespace {

void applyFactors(const std::array<GLint, 4>& factors) {
  const std::array<GLenum, 4> f{
      nameOf(factors[0]), nameOf(factors[1]), nameOf(factors[2]), nameOf(factors[3])};
  if (hasStateOfEachDrawBuffer()) {
    glBlendFuncSeparatei(0, f[0], f[1], f[2], f[3]);
  } else {
    glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
  }
}

}  // namespace

GlRenderState GlRenderState::current() {
  GlRenderState state;
  glGetIntegerv(GL_SCISSOR_BOX, state.scissor_box.data());
  state.blend_factors = {glInteger(GL_BLEND_SRC_RGB),
                         glInteger(GL_BLEND_DST_RGB),
                         glInteger(GL_BLEND_SRC_ALPHA),
                         glInteger(GL_BLEND_DST_ALPHA)};
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
  applyFactors(blend_factors);
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
  applyFactors({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA});
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDepthRangef(0.0F, 1.0F);
  glClearDepthf(1.0F);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace glide
