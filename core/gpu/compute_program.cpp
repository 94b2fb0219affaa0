#include "gpu/compute_program.h"

namespace glide {
namespace {

using GetParameter = void (*)(GLuint, GLenum, GLint*);
using GetLog = void (*)(GLuint, GLsizei, GLsizei*, GLchar*);

/// The driver's complaint about a shader or program.
std::string infoLog(GLuint name, GetParameter get_parameter, GetLog get_log) {
  GLint length = 0;
  get_parameter(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  GLsizei written = 0;
  if (length > 0) get_log(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

Error buildError(std::string_view name, const char* step, const std::string& log) {
  return {ErrorCode::gl, "shader " + std::string(name) + " does not " + step + ": " + log};
}

}  // namespace

Result<ComputeProgram> ComputeProgram::create(std::string_view name, const ShaderDefines& defines) {
  Result<std::string> text = assembleShader(embeddedShaders(), name, defines);
  if (!text) return text.error();
  return compile(name, *text);
}

Result<ComputeProgram> ComputeProgram::compile(std::string_view name, const std::string& text) {
  const GlShader shader(glCreateShader(GL_COMPUTE_SHADER));
  const GLchar* source = text.c_str();
  glShaderSource(shader.get(), 1, &source, nullptr);
  glCompileShader(shader.get());
  GLint ok = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
  if (ok != GL_TRUE) {
    return buildError(name, "compile", infoLog(shader.get(), glGetShaderiv, glGetShaderInfoLog));
  }
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), shader.get());
  glLinkProgram(program.get());
  glDetachShader(program.get(), shader.get());
  glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) {
    return buildError(name, "link", infoLog(program.get(), glGetProgramiv, glGetProgramInfoLog));
  }
  return ComputeProgram(std::move(program));
}

}  // namespace glide
