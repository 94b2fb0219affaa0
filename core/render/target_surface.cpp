#include "render/target_surface.h"

namespace glide {
namespace {

/// A renderbuffer, attached to the framebuffer that is bound for drawing.
GlRenderbuffer attach(GLenum attachment, GLenum storage, const TargetSurface::Format& format) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(
      GL_RENDERBUFFER, format.samples, storage, format.width, format.height);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  return GlRenderbuffer(name);
}

}  // namespace

void deleteRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }

TargetSurface TargetSurface::allocate(const Format& format) {
  TargetSurface made;
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  made.framebuffer_ = GlFramebuffer(name);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
  made.color_ = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, format);
  if (format.depth == Depth::attached)
    made.depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, format);
  // What has got no memory is no attachment that would be complete.
  made.is_complete_ = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  return made;
}

}  // namespace glide
