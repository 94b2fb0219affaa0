#include "gpu/gl_objects.h"

#include <cassert>
#include <cstring>
#include <string>

namespace glide {

void deleteBuffer(GLuint name) { glDeleteBuffers(1, &name); }
void deleteTexture(GLuint name) { glDeleteTextures(1, &name); }
void deleteProgram(GLuint name) { glDeleteProgram(name); }
void deleteShader(GLuint name) { glDeleteShader(name); }
void deleteSampler(GLuint name) { glDeleteSamplers(1, &name); }
void deleteFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
void deleteVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }

Error outOfMemory(std::string_view what) {
  return {ErrorCode::gl, "no GL memory for " + std::string(what)};
}

GlBuffer GlBuffer::allocate(std::int64_t bytes, GLenum usage) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  GlBuffer buffer;
  buffer.name_ = GlName<deleteBuffer>(name);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, usage);
  GLint64 size = 0;
  glGetBufferParameteri64v(GL_SHADER_STORAGE_BUFFER, GL_BUFFER_SIZE, &size);
  buffer.bytes_ = size == bytes ? bytes : 0;
  return buffer;
}

void GlBuffer::write(const void* data, std::int64_t bytes) const { writeRange(data, 0, bytes); }

void GlBuffer::writeRange(const void* data, std::int64_t offset, std::int64_t bytes) const {
  assert(offset + bytes <= bytes_);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_.get());
  glBufferSubData(GL_SHADER_STORAGE_BUFFER,
                  static_cast<GLintptr>(offset),
                  static_cast<GLsizeiptr>(bytes),
                  data);
}

bool GlBuffer::read(void* data, std::int64_t bytes) const {
  assert(bytes <= bytes_);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_.get());
  const auto size = static_cast<GLsizeiptr>(bytes);
  const void* mapped = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, size, GL_MAP_READ_BIT);
  if (mapped == nullptr) return false;
  std::memcpy(data, mapped, static_cast<std::size_t>(bytes));
  return glUnmapBuffer(GL_SHADER_STORAGE_BUFFER) == GL_TRUE;
}

GlTexture GlTexture::allocate(GLenum format, int width, int height) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture;
  texture.name_ = GlName<deleteTexture>(name);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  GLint stored_width = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &stored_width);
  texture.width_ = stored_width == width ? width : 0;
  texture.height_ = height;
  return texture;
}

GlSync GlSync::insert() { return GlSync(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)); }

bool GlSync::wait(std::uint64_t timeout_ns) const {
  const GLenum status = glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, timeout_ns);
  return status == GL_ALREADY_SIGNALED || status == GL_CONDITION_SATISFIED;
}

}  // namespace glide
