#include "render/target_state.h"

#include "gpu/gl_query.h"

namespace glide {
namespace {

void applyPack(const GlTargetState& state) {
  glBindBuffer(GL_PIXEL_PACK_BUFFER, nameOf(state.pack_buffer));
  glPixelStorei(GL_PACK_ALIGNMENT, state.pack_alignment);
  glPixelStorei(GL_PACK_ROW_LENGTH, state.pack_row_length);
  glPixelStorei(GL_PACK_SKIP_ROWS, state.pack_skip_rows);
  glPixelStorei(GL_PACK_SKIP_PIXELS, state.pack_skip_pixels);
}

}  // namespace

GlTargetState GlTargetState::current() {
  return {glInteger(GL_DRAW_FRAMEBUFFER_BINDING),
          glInteger(GL_READ_FRAMEBUFFER_BINDING),
          glInteger(GL_RENDERBUFFER_BINDING),
          glInteger(GL_PIXEL_PACK_BUFFER_BINDING),
          glInteger(GL_PACK_ALIGNMENT),
          glInteger(GL_PACK_ROW_LENGTH),
          glInteger(GL_PACK_SKIP_ROWS),
          glInteger(GL_PACK_SKIP_PIXELS)};
}

void GlTargetState::apply() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nameOf(draw_framebuffer));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, nameOf(read_framebuffer));
  glBindRenderbuffer(GL_RENDERBUFFER, nameOf(renderbuffer));
  applyPack(*this);
}

void GlTargetState::neutralize() {
  GlTargetState neutral;
  neutral.pack_alignment = 1;
  applyPack(neutral);
}

}  // namespace glide
