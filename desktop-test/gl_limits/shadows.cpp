// The functions of OpenGL ES that this library stands before, when it is preloaded (LD_PRELOAD): a
// device with the least that OpenGL ES 3.1 allows. What goes beyond gets the error that such a
// device gives: a program does not link, a call is GL_INVALID_VALUE. The rest of GL is the
// driver's.
#include "gl_limits/floors.h"
#include "gl_limits/program_limits.h"
#include "gl_limits/real_gl.h"
#include "gl_limits/shared_memory.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <mutex>
#include <string>

namespace glide::gl_limits {
namespace {

/// An index that no driver has: the call then is the error that it must be.
constexpr GLuint kNowhere = 0x7FFFFFFF;

/// The programs that the driver has linked and the floor device has not, with its reason.
struct RefusedPrograms {
  std::mutex mutex;
  std::map<GLuint, std::string> reasons;
};

RefusedPrograms& refusedPrograms() {
  static RefusedPrograms programs;  // C functions have nowhere else to keep it
  return programs;
}

std::string reasonOf(GLuint program) {
  RefusedPrograms& refused = refusedPrograms();
  const std::lock_guard lock(refused.mutex);
  const auto found = refused.reasons.find(program);
  return found == refused.reasons.end() ? std::string() : found->second;
}

void setReason(GLuint program, const std::string& reason) {
  RefusedPrograms& refused = refusedPrograms();
  const std::lock_guard lock(refused.mutex);
  refused.reasons.erase(program);
  if (!reason.empty()) refused.reasons.emplace(program, reason);
}

std::string judge(GLuint program) {
  GLint linked = GL_FALSE;
  GLIDE_REAL_GL(glGetProgramiv)(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) return {};
  const std::string uses = usesBeyondFloors(program);
  if (!uses.empty()) return "beyond the floors of OpenGL ES 3.1: " + uses;
  if (sharedMemoryFits(program)) return {};
  return "beyond the floors of OpenGL ES 3.1: more than " + std::to_string(kSharedBytes) +
         " bytes of shared memory";
}

GLuint allowedBinding(GLenum target, GLuint index) {
  const bool allowed = target == GL_SHADER_STORAGE_BUFFER ? index < kStorageBindings
                       : target == GL_UNIFORM_BUFFER      ? index < kUniformBindings
                                                          : true;
  return allowed ? index : kNowhere;
}

}  // namespace
}  // namespace glide::gl_limits

using namespace glide::gl_limits;  // NOLINT(google-build-using-namespace): below is only its
                                   // interface

extern "C" {

/// Tells that the library is there.
__attribute__((visibility("default"))) int glideGlLimits() { return 1; }

#define GLIDE_SHADOW __attribute__((visibility("default"))) void GL_APIENTRY

GLIDE_SHADOW glGetIntegerv(GLenum pname, GLint* data) {
  GLIDE_REAL_GL(glGetIntegerv)(pname, data);
  if (const auto floor = floorOf(pname)) *data = *floor;
}

GLIDE_SHADOW glGetInteger64v(GLenum pname, GLint64* data) {
  GLIDE_REAL_GL(glGetInteger64v)(pname, data);
  if (const auto floor = floorOf(pname)) *data = *floor;
}

GLIDE_SHADOW glGetIntegeri_v(GLenum target, GLuint index, GLint* data) {
  GLIDE_REAL_GL(glGetIntegeri_v)(target, index, data);
  if (index >= std::size(kGroupSize)) return;
  if (target == GL_MAX_COMPUTE_WORK_GROUP_SIZE) *data = kGroupSize[index];
  if (target == GL_MAX_COMPUTE_WORK_GROUP_COUNT) *data = kGroupCount;
}

/// A hidden extension leaves an empty name in the list.
__attribute__((visibility("default"))) const GLubyte* GL_APIENTRY glGetStringi(GLenum name,
                                                                               GLuint index) {
  const GLubyte* text = GLIDE_REAL_GL(glGetStringi)(name, index);
  if (name != GL_EXTENSIONS || text == nullptr) return text;
  return isHidden(reinterpret_cast<const char*>(text))
             ? text + std::strlen(reinterpret_cast<const char*>(text))
             : text;
}

GLIDE_SHADOW glLinkProgram(GLuint program) {
  GLIDE_REAL_GL(glLinkProgram)(program);
  setReason(program, judge(program));
}

GLIDE_SHADOW glDeleteProgram(GLuint program) {
  setReason(program, {});
  GLIDE_REAL_GL(glDeleteProgram)(program);
}

GLIDE_SHADOW glGetProgramiv(GLuint program, GLenum pname, GLint* params) {
  GLIDE_REAL_GL(glGetProgramiv)(program, pname, params);
  const std::string reason = reasonOf(program);
  if (reason.empty()) return;
  if (pname == GL_LINK_STATUS) *params = GL_FALSE;
  if (pname == GL_INFO_LOG_LENGTH) *params = static_cast<GLint>(reason.size()) + 1;
}

GLIDE_SHADOW glGetProgramInfoLog(GLuint program, GLsizei size, GLsizei* length, GLchar* log) {
  const std::string reason = reasonOf(program);
  if (reason.empty() || size <= 0) {
    GLIDE_REAL_GL(glGetProgramInfoLog)(program, size, length, log);
    return;
  }
  const std::size_t written = std::min(reason.size(), static_cast<std::size_t>(size) - 1);
  std::memcpy(log, reason.data(), written);
  log[written] = '\0';
  if (length != nullptr) *length = static_cast<GLsizei>(written);
}

GLIDE_SHADOW glDispatchCompute(GLuint x, GLuint y, GLuint z) {
  const bool allowed = std::max({x, y, z}) <= static_cast<GLuint>(kGroupCount);
  GLIDE_REAL_GL(glDispatchCompute)(allowed ? x : kNowhere, y, z);
}

GLIDE_SHADOW glBindBufferBase(GLenum target, GLuint index, GLuint buffer) {
  GLIDE_REAL_GL(glBindBufferBase)(target, allowedBinding(target, index), buffer);
}

GLIDE_SHADOW glBindBufferRange(
    GLenum target, GLuint index, GLuint buffer, GLintptr offset, GLsizeiptr size) {
  GLIDE_REAL_GL(glBindBufferRange)(target, allowedBinding(target, index), buffer, offset, size);
}

// NOLINTNEXTLINE(readability-function-size): the signature is that of OpenGL ES
GLIDE_SHADOW glBindImageTexture(GLuint unit,
                                GLuint texture,
                                GLint level,
                                GLboolean layered,
                                GLint layer,
                                GLenum access,
                                GLenum format) {
  const GLuint allowed = unit < kImageUnits ? unit : kNowhere;
  GLIDE_REAL_GL(glBindImageTexture)(allowed, texture, level, layered, layer, access, format);
}

GLIDE_SHADOW glTexStorage2D(
    GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
  const bool allowed = std::max(width, height) <= kTextureSize;
  GLIDE_REAL_GL(glTexStorage2D)(target, levels, format, allowed ? width : -1, height);
}

}  // extern "C"
