#include "gpu/gl_raster_state.h"

#include "gpu/gl_query.h"

// ES 3.2, for the state of one draw buffer: called only in such contexts.
#include <GLES3/gl32.h>

namespace glide {
namespace {

bool isEnabled(GLenum capability) { return glIsEnabled(capability) == GL_TRUE; }

void setCapability(GLenum capability, bool enabled) {
  if (enabled) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

using ColorMask = std::array<GLboolean, 4>;

void applyFirstDrawBuffer(bool blend, const ColorMask& mask) {
  if (!hasStateOfEachDrawBuffer()) {
    setCapability(GL_BLEND, blend);
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

void applyEquations(const std::array<GLint, 2>& equations) {
  const bool of_each = hasStateOfEachDrawBuffer();
  const GLenum rgb = nameOf(equations[0]);
  const GLenum alpha = nameOf(equations[1]);
  if (rgb != alpha) {
    of_each ? glBlendEquationSeparatei(0, rgb, alpha) : glBlendEquationSeparate(rgb, alpha);
  } else {  // the only functions that take an equation of KHR_blend_equation_advanced
    of_each ? glBlendEquationi(0, rgb) : glBlendEquation(rgb);
  }
}

void applyTests(const GlRasterState& state) {
  applyFirstDrawBuffer(state.blend, state.color_mask);
  applyEquations(state.blend_equations);
  setCapability(GL_DEPTH_TEST, state.depth_test);
  setCapability(GL_STENCIL_TEST, state.stencil_test);
  setCapability(GL_SCISSOR_TEST, state.scissor_test);
  setCapability(GL_CULL_FACE, state.cull_face);
  setCapability(GL_RASTERIZER_DISCARD, state.rasterizer_discard);
  setCapability(GL_DITHER, state.dither);
  setCapability(GL_SAMPLE_COVERAGE, state.sample_coverage);
  setCapability(GL_SAMPLE_ALPHA_TO_COVERAGE, state.sample_alpha_to_coverage);
  setCapability(GL_SAMPLE_MASK, state.sample_mask);
}

}  // namespace

bool hasStateOfEachDrawBuffer() {
  const GLint major = glInteger(GL_MAJOR_VERSION);
  return major > 3 || (major == 3 && glInteger(GL_MINOR_VERSION) >= 2);
}

GlRasterState GlRasterState::current() {
  GlRasterState state;
  state.vertex_array = glInteger(GL_VERTEX_ARRAY_BINDING);
  state.array_buffer = glInteger(GL_ARRAY_BUFFER_BINDING);
  glGetIntegerv(GL_VIEWPORT, state.viewport.data());
  glGetBooleanv(GL_COLOR_WRITEMASK, state.color_mask.data());
  state.blend = isEnabled(GL_BLEND);
  state.blend_equations = {glInteger(GL_BLEND_EQUATION_RGB), glInteger(GL_BLEND_EQUATION_ALPHA)};
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

GlRasterState GlRasterState::initial() {
  GlRasterState state;
  glGetIntegerv(GL_VIEWPORT, state.viewport.data());
  return state;
}

void GlRasterState::apply() const {
  glBindVertexArray(nameOf(vertex_array));
  glBindBuffer(GL_ARRAY_BUFFER, nameOf(array_buffer));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  applyTests(*this);
}

void GlRasterState::neutralize() {
  GlRasterState neutral;
  neutral.dither = false;
  applyTests(neutral);
}

}  // namespace glide
