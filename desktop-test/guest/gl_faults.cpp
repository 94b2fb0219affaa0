#include "guest/gl_faults.h"

#include <GLES3/gl31.h>

#include <dlfcn.h>

namespace {

glide::test::WaitFault g_wait_fault = glide::test::WaitFault::none;

}  // namespace

namespace glide::test {

void setWaitFault(WaitFault fault) { g_wait_fault = fault; }

}  // namespace glide::test

/// Takes the place of the driver's: the linker prefers the program's functions to a library's.
extern "C" GLenum GL_APIENTRY glClientWaitSync(GLsync sync, GLbitfield flags, GLuint64 timeout) {
  using WaitSync = GLenum (*)(GLsync, GLbitfield, GLuint64);
  static const auto next = reinterpret_cast<WaitSync>(dlsym(RTLD_NEXT, "glClientWaitSync"));
  if (g_wait_fault == glide::test::WaitFault::lost) return GL_WAIT_FAILED;
  if (g_wait_fault == glide::test::WaitFault::timeout) return GL_TIMEOUT_EXPIRED;
  return next(sync, flags, timeout);
}
