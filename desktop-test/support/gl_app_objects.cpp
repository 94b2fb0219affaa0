#include "support/gl_app.h"

#include <cstring>
#include <string>

namespace glide::test {
namespace {

constexpr GLenum kTextureParameters[] = {GL_TEXTURE_MIN_FILTER,
                                         GL_TEXTURE_MAG_FILTER,
                                         GL_TEXTURE_WRAP_S,
                                         GL_TEXTURE_WRAP_T,
                                         GL_TEXTURE_WRAP_R,
                                         GL_TEXTURE_MIN_LOD,
                                         GL_TEXTURE_MAX_LOD,
                                         GL_TEXTURE_BASE_LEVEL,
                                         GL_TEXTURE_MAX_LEVEL,
                                         GL_TEXTURE_COMPARE_MODE,
                                         GL_TEXTURE_COMPARE_FUNC,
                                         GL_TEXTURE_SWIZZLE_R,
                                         GL_TEXTURE_SWIZZLE_G,
                                         GL_TEXTURE_SWIZZLE_B,
                                         GL_TEXTURE_SWIZZLE_A,
                                         GL_TEXTURE_IMMUTABLE_FORMAT,
                                         GL_TEXTURE_IMMUTABLE_LEVELS,
                                         GL_DEPTH_STENCIL_TEXTURE_MODE};
constexpr GLenum kLevelParameters[] = {
    GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_INTERNAL_FORMAT};
constexpr GLenum kSamplerParameters[] = {GL_TEXTURE_MIN_FILTER,
                                         GL_TEXTURE_MAG_FILTER,
                                         GL_TEXTURE_WRAP_S,
                                         GL_TEXTURE_WRAP_T,
                                         GL_TEXTURE_WRAP_R,
                                         GL_TEXTURE_MIN_LOD,
                                         GL_TEXTURE_MAX_LOD,
                                         GL_TEXTURE_COMPARE_MODE,
                                         GL_TEXTURE_COMPARE_FUNC};
constexpr GLenum kBufferParameters[] = {GL_BUFFER_SIZE,
                                        GL_BUFFER_USAGE,
                                        GL_BUFFER_MAPPED,
                                        GL_BUFFER_ACCESS_FLAGS,
                                        GL_BUFFER_MAP_OFFSET,
                                        GL_BUFFER_MAP_LENGTH};

GLuint bound(GLenum query) {
  GLint value = 0;
  glGetIntegerv(query, &value);
  return static_cast<GLuint>(value);
}

GLenum bindingOf(GLenum target) {
  switch (target) {
    case GL_TEXTURE_3D:
      return GL_TEXTURE_BINDING_3D;
    case GL_TEXTURE_2D_ARRAY:
      return GL_TEXTURE_BINDING_2D_ARRAY;
    case GL_TEXTURE_CUBE_MAP:
      return GL_TEXTURE_BINDING_CUBE_MAP;
    case GL_TEXTURE_2D_MULTISAMPLE:
      return GL_TEXTURE_BINDING_2D_MULTISAMPLE;
    default:
      return GL_TEXTURE_BINDING_2D;
  }
}

std::vector<double> textureValues(GLenum target) {
  std::vector<double> values;
  for (const GLenum parameter : kTextureParameters) {
    GLfloat value = 0.0F;
    glGetTexParameterfv(target, parameter, &value);
    values.push_back(static_cast<double>(value));
  }
  const GLenum face = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
  for (const GLenum parameter : kLevelParameters) {
    GLint value = 0;
    glGetTexLevelParameteriv(face, 0, parameter, &value);
    values.push_back(value);
  }
  return values;
}

std::vector<double> samplerValues(GLuint sampler) {
  std::vector<double> values;
  for (const GLenum parameter : kSamplerParameters) {
    GLfloat value = 0.0F;
    glGetSamplerParameterfv(sampler, parameter, &value);
    values.push_back(static_cast<double>(value));
  }
  return values;
}

/// Parameters, and the contents unless it is mapped, of the buffer at GL_COPY_READ_BUFFER.
std::vector<double> bufferValues() {
  std::vector<double> values;
  for (const GLenum parameter : kBufferParameters) {
    GLint64 value = 0;
    glGetBufferParameteri64v(GL_COPY_READ_BUFFER, parameter, &value);
    values.push_back(static_cast<double>(value));
  }
  if (values[2] != 0.0) return values;
  const auto bytes = static_cast<GLsizeiptr>(values[0]);
  const void* mapped = glMapBufferRange(GL_COPY_READ_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(bytes) / sizeof(std::uint32_t));
  if (mapped != nullptr) std::memcpy(words.data(), mapped, static_cast<std::size_t>(bytes));
  glUnmapBuffer(GL_COPY_READ_BUFFER);
  values.insert(values.end(), words.begin(), words.end());
  return values;
}

/// Attachments, draw and read buffers of the framebuffer at GL_READ_FRAMEBUFFER.
std::vector<double> framebufferValues() {
  std::vector<double> values;
  for (const GLenum attachment :
       {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT}) {
    for (const GLenum parameter :
         {GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME}) {
      GLint value = 0;
      glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, attachment, parameter, &value);
      values.push_back(value);
    }
  }
  values.push_back(bound(GL_READ_BUFFER));
  values.push_back(glCheckFramebufferStatus(GL_READ_FRAMEBUFFER));
  return values;
}

std::vector<double> uniformValues(GLuint program) {
  GLfloat value[4] = {};
  glGetUniformfv(program, 0, value);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return {value[0], value[1], value[2], value[3], static_cast<double>(linked)};
}

}  // namespace

GlSnapshot GlApp::objects() const {
  GlSnapshot out;
  out["intact"] = {isIntact() ? 1.0 : 0.0};
  for (const AppTexture& texture : textures_) {
    const GLuint previous = bound(bindingOf(texture.target));
    glBindTexture(texture.target, texture.name);
    out["texture " + std::to_string(texture.name)] = textureValues(texture.target);
    glBindTexture(texture.target, previous);
  }
  for (const GLuint sampler : samplers_)
    out["sampler " + std::to_string(sampler)] = samplerValues(sampler);
  const GLuint copy_buffer = bound(GL_COPY_READ_BUFFER_BINDING);
  for (const GLuint buffer : buffers_) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    out["buffer " + std::to_string(buffer)] = bufferValues();
  }
  glBindBuffer(GL_COPY_READ_BUFFER, copy_buffer);
  const GLuint read_framebuffer = bound(GL_READ_FRAMEBUFFER_BINDING);
  for (const GLuint framebuffer : framebuffers_) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    out["framebuffer " + std::to_string(framebuffer)] = framebufferValues();
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, read_framebuffer);
  const GLuint vertex_array = bound(GL_VERTEX_ARRAY_BINDING);
  for (const GLuint array : vertex_arrays_) {
    glBindVertexArray(array);
    addAll("vertex array " + std::to_string(array) + ": ", vertexArrayState(), &out);
  }
  glBindVertexArray(vertex_array);
  for (const GLuint program : {compute_, drawing_, vertex_stage_})
    out["program " + std::to_string(program)] = uniformValues(program);
  GLint stage = 0;
  glGetProgramPipelineiv(pipeline_, GL_VERTEX_SHADER, &stage);
  out["pipeline"] = {static_cast<double>(stage)};
  return out;
}

}  // namespace glide::test
