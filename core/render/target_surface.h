#pragma once

#include "gpu/gl_objects.h"

namespace glide {

void deleteRenderbuffer(GLuint name);
using GlRenderbuffer = GlName<deleteRenderbuffer>;
using GlFramebuffer = GlName<deleteFramebuffer>;

/// A framebuffer of renderbuffers: RGBA8 colour and, if wanted, depth. Framebuffers are not shared
/// between contexts: it belongs to the one that it was made in. Its functions leave the bindings of
/// framebuffers and renderbuffers changed.
class TargetSurface {
 public:
  enum class Depth { none, attached };
  struct Format {
    int width = 0, height = 0;  ///< px
    int samples = 0;            ///< 0 or 1: not multisampled
    Depth depth = Depth::none;
  };

  /// Without memory for it, not complete.
  static TargetSurface allocate(const Format& format);
  bool isComplete() const { return is_complete_; }

  GLuint framebuffer() const { return framebuffer_.get(); }
  void abandon() { abandonAll(color_, depth_, framebuffer_); }
  /// In another context of the same group, which has the renderbuffers only.
  void abandonFramebuffer() { framebuffer_.abandon(); }

 private:
  GlRenderbuffer color_, depth_;
  GlFramebuffer framebuffer_;
  bool is_complete_ = false;
};

}  // namespace glide
