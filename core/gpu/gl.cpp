#include "gpu/gl.h"

#include <cassert>
#include <string>

namespace glide {
namespace {

/// A lost context reports errors without end.
constexpr int kMaxErrors = 64;

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "unknown GL error";
  }
}

}  // namespace

void drainGlErrors() {
  for (int i = 0; i < kMaxErrors && glGetError() != GL_NO_ERROR; ++i) {
  }
}

std::optional<Error> takeGlError(std::string_view pass) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return std::nullopt;
  drainGlErrors();
  return Error{ErrorCode::gl, std::string(pass) + ": " + errorName(error)};
}

void beginGlPass() {
#ifndef NDEBUG
  drainGlErrors();
#endif
}

void assertNoGlError([[maybe_unused]] std::string_view pass) {
#ifndef NDEBUG
  const std::optional<Error> error = takeGlError(pass);
  assert(!error && "a GL call of this pass failed");
#endif
}

}  // namespace glide
