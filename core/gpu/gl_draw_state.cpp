#include "gpu/gl_draw_state.h"

#include "gpu/gl_query.h"

// ES 3.2, for the state of one draw buffer: called only in such contexts.
#include <GLES3/gl32.h>

namespace glide {
namespace {

/// Whether each draw buffer has its own blending and colour mask, which glDisable(GL_BLEND) and
/// glColorMask would set for all of them.
bool hasStateOfEachDrawBuffer() {
  const GLint major = glInteger(GL_MAJOR_VERSION);
  return major > 3 || (major == 3 && glInteger(GL_MINOR_VERSION) >= 2);
}

bool isEnabled(GLenum capability) { return glIsEnabled(capability) == GL_TRUE; }

void setEnabled(GLenum capability, bool enabled) {
  if (enabled) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

using ColorMask = std::array<GLboolean, 4>;

void applyFirstDrawBuffer(bool blend, const ColorMask& mask) {
  if (!hasStateOfEachDrawBuffer()) {
    setEnabled(GL_BLEND, blend);
    glColorMask(mask[0], mask[1], mask[2], mask[3]);
    return;
  }
  if (blend) {
    glEnablei(GL_BLEND, 0);
  } else {
    glDisablei(GL_BLEND, 0);
  }
  glColorMaski(0, mask[0], mask[1], mask[2], mask[3]);
}

void applyTests(const GlDrawState& state) {
  applyFirstDrawBuffer(state.blend, state.color_mask);
  setEnabled(GL_DEPTH_TEST, state.depth_test);
  setEnabled(GL_STENCIL_TEST, state.stencil_test);
  setEnabled(GL_SCISSOR_TEST, state.scissor_test);
  setEnabled(GL_CULL_FACE, state.cull_face);
  setEnabled(GL_RASTERIZER_DISCARD, state.rasterizer_discard);
  setEnabled(GL_DITHER, state.dither);
  setEnabled(GL_SAMPLE_COVERAGE, state.sample_coverage);
  setEnabled(GL_SAMPLE_ALPHA_TO_COVERAGE, state.sample_alpha_to_coverage);
  setEnabled(GL_SAMPLE_MASK, state.sample_mask);
}

}  // namespace

GlDrawState GlDrawState::current() {
  GlDrawState state;
  state.draw_framebuffer = glInteger(GL_DRAW_FRAMEBUFFER_BINDING);
  state.read_framebuffer = glInteger(GL_READ_FRAMEBUFFER_BINDING);
  state.vertex_array = glInteger(GL_VERTEX_ARRAY_BINDING);
  state.array_buffer = glInteger(GL_ARRAY_BUFFER_BINDING);
  glGetIntegerv(GL_VIEWPORT, state.viewport.data());
  glGetBooleanv(GL_COLOR_WRITEMASK, state.color_mask.data());
  state.blend = isEnabled(GL_BLEND);
  state.depth_test = isEnabled(GL_DEPTH_TEST);
  state.stencil_test = isEnabled(GL_STENCIL_TEST);
  state.scissor_test = isEnabled(GL_SCISSOR_TEST);
  state.cull_face = isEnabled(GL_CULL_FACE);
  state.rasterizer_discard = isEnabled(GL_RASTERIZER_DISCARD);
  state.dither = isEnabled(GL_DITHER);
  state.sample_coverage = isEnabled(GL_SAMPLE_COVERAGE);
  state.sample_alpha_to_coverage = isEnabled(GL_SAMPLE_ALPHA_TO_COVERAGE);
  state.sample_mask = isEnabled(GL_SAMPLE_MASK);
  return state;
}

GlDrawState GlDrawState::initial() {
  GlDrawState state;
  glGetIntegerv(GL_VIEWPORT, state.viewport.data());
  return state;
}

void GlDrawState::apply() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nameOf(draw_framebuffer));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, nameOf(read_framebuffer));
  glBindVertexArray(nameOf(vertex_array));
  glBindBuffer(GL_ARRAY_BUFFER, nameOf(array_buffer));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  applyTests(*this);
}

void GlDrawState::neutralize() {
  GlDrawState neutral;
  neutral.dither = false;
  applyTests(neutral);
}

}  // namespace glide
