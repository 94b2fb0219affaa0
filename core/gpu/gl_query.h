#pragma once

#include "gpu/gl.h"

namespace glide {

/// A name, or an enum, as glGetIntegerv gave it.
inline GLuint nameOf(GLint value) { return static_cast<GLuint>(value); }

/// glGetIntegerv of one number.
inline GLint glInteger(GLenum query) {
  GLint value = 0;
  glGetIntegerv(query, &value);
  return value;
}

/// glGetIntegeri_v of one number.
inline GLint glInteger(GLenum query, GLuint index) {
  GLint value = 0;
  glGetIntegeri_v(query, index, &value);
  return value;
}

}  // namespace glide
