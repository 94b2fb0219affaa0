#include "gpu/gl_draw_state.h"

#include "gpu/gl_query.h"

namespace glide {

GlDrawState GlDrawState::current() {
  return {glInteger(GL_DRAW_FRAMEBUFFER_BINDING),
          glInteger(GL_READ_FRAMEBUFFER_BINDING),
          GlRasterState::current()};
}

GlDrawState GlDrawState::initial() { return {0, 0, GlRasterState::initial()}; }

void GlDrawState::apply() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nameOf(draw_framebuffer));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, nameOf(read_framebuffer));
  raster.apply();
}

void GlDrawState::neutralize() { GlRasterState::neutralize(); }

}  // namespace glide
