#include "gpu/program_build.h"

#include <array>
#include <cstddef>

namespace glide {
namespace {

using GetParameter = void (*)(GLuint, GLenum, GLint*);
using GetLog = void (*)(GLuint, GLsizei, GLsizei*, GLchar*);

// A program has a vertex and a fragment shader, or a compute shader.
constexpr std::size_t kMaxStages = 2;

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

void detachAll(GLuint program) {
  std::array<GLuint, kMaxStages> shaders{};
  GLsizei count = 0;
  glGetAttachedShaders(program, static_cast<GLsizei>(shaders.size()), &count, shaders.data());
  for (GLsizei i = 0; i < count; ++i) glDetachShader(program, shaders[static_cast<std::size_t>(i)]);
}

}  // namespace

Result<GlShader> compileShader(GLenum stage, std::string_view name, const std::string& text) {
  GlShader shader(glCreateShader(stage));
  const GLchar* source = text.c_str();
  glShaderSource(shader.get(), 1, &source, nullptr);
  glCompileShader(shader.get());
  GLint ok = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  return buildError(name, "compile", infoLog(shader.get(), glGetShaderiv, glGetShaderInfoLog));
}

Status linkProgram(std::string_view name, const GlProgram& program) {
  glLinkProgram(program.get());
  detachAll(program.get());
  GLint ok = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return Unit{};
  return buildError(name, "link", infoLog(program.get(), glGetProgramiv, glGetProgramInfoLog));
}

}  // namespace glide
