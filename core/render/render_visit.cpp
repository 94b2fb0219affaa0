#include "render/render_visit.h"

// ES 3.2, for the state of one draw buffer: called only in such contexts.
#include <GLES3/gl32.h>

#include <string>

namespace glide {

RenderVisit::RenderVisit(GlHome* home, GlStatePolicy policy)
    : visit_(home, policy), raster_(policy), state_(policy) {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  glBindVertexArray(name);
  vertices_ = GlName<deleteVertexArray>(name);
}

Status checkFramebuffer() {
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return Unit{};
  return Error{ErrorCode::invalid_argument, "no complete framebuffer is bound for drawing"};
}

Status checkViewport(const Viewport& viewport) {
  if (viewport.width > 0 && viewport.height > 0) return Unit{};
  return Error{ErrorCode::invalid_argument,
               "viewport of " + std::to_string(viewport.width) + "x" +
                   std::to_string(viewport.height) + " px"};
}

void setBlending(Blending blending) {
  const bool of_each = hasStateOfEachDrawBuffer();
  if (blending == Blending::on) {
    of_each ? glEnablei(GL_BLEND, 0) : glEnable(GL_BLEND);
  } else {
    of_each ? glDisablei(GL_BLEND, 0) : glDisable(GL_BLEND);
  }
}

}  // namespace glide
