#pragma once

#include "gpu/gl_objects.h"

namespace glide {

/// A sampler object that repeats the texture's border; `filter` is GL_NEAREST or GL_LINEAR. 0 when
/// the context gives none.
GlSampler makeClampedSampler(GLint filter);

}  // namespace glide
