#pragma once

#include <dlfcn.h>

namespace glide::gl_limits {

/// The driver's function behind one that this library shadows.
template <class Function>
Function* realGl(Function* /*shadow*/, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace glide::gl_limits

/// The driver's gl function of this name.
#define GLIDE_REAL_GL(function) (glide::gl_limits::realGl(&function, #function))
