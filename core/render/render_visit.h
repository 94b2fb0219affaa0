#pragma once

#include "render/gl_render_state.h"

#include "gpu/gl_home.h"
#include "gpu/gl_raster_state.h"

#include "glide/render_types.h"
#include "glide/result.h"

namespace glide {

/// One call of a renderer in the app's context: its state, the order of what contexts submit, and a
/// vertex array of its own, bound. It draws into the framebuffer that is bound, which stays bound
/// whatever the policy. The home is of the context.
class RenderVisit {
 public:
  RenderVisit(GlHome* home, GlStatePolicy policy);

 private:
  GlVisit visit_;
  ScopedState<GlRasterState> raster_;
  ScopedRenderState state_;
  GlName<deleteVertexArray> vertices_;
};

/// invalid_argument when what is bound for drawing is no complete framebuffer, such as that of a
/// context without a surface: drawing would raise an error.
Status checkFramebuffer();

/// invalid_argument, with its size, for one without pixels.
Status checkViewport(const Viewport& viewport);

/// glEnable or glDisable (GL_BLEND) of draw buffer 0.
enum class Blending { off, on };
void setBlending(Blending blending);

}  // namespace glide
