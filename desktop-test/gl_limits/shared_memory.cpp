#include "gl_limits/shared_memory.h"

#include "gl_limits/floors.h"
#include "gl_limits/real_gl.h"

#include <array>
#include <string>
#include <vector>

namespace glide::gl_limits {
namespace {

std::string sourceOf(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  std::string source(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  glGetShaderSource(shader, length, &written, source.data());
  source.resize(static_cast<std::size_t>(written));
  return source;
}

/// Bytes that this driver has beyond the floor.
int spareBytes() {
  GLint bytes = 0;
  GLIDE_REAL_GL(glGetIntegerv)(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &bytes);
  return bytes - kSharedBytes;
}

/// The same shader with `bytes` more of shared memory. Its main() depends on them, or the compiler
/// would leave them out.
std::string padded(const std::string& source, int bytes) {
  const std::size_t first_line_end = source.find('\n');  // of #version
  const std::string words = std::to_string(bytes / 4);
  return source.substr(0, first_line_end + 1) + "#define main glideMain\n" +
         source.substr(first_line_end + 1) + "\n#undef main\nshared uint glide_pad[" + words +
         "];\nvoid main() {\n  glide_pad[gl_WorkGroupID.x % " + words +
         "u] = gl_WorkGroupID.y;\n  barrier();\n  if (glide_pad[gl_WorkGroupID.z % " + words +
         "u] != 12345u) glideMain();\n}\n";
}

bool links(const std::string& source) {
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  GLIDE_REAL_GL(glLinkProgram)(program);
  GLint linked = GL_FALSE;
  GLIDE_REAL_GL(glGetProgramiv)(program, GL_LINK_STATUS, &linked);
  glDeleteProgram(program);
  glDeleteShader(shader);
  return linked == GL_TRUE;
}

}  // namespace

bool sharedMemoryFits(GLuint program) {
  std::array<GLuint, 8> shaders{};
  GLsizei count = 0;
  glGetAttachedShaders(program, static_cast<GLsizei>(shaders.size()), &count, shaders.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::string source = sourceOf(shaders[i]);
    if (source.find("shared") == std::string::npos) continue;
    if (!links(padded(source, spareBytes()))) return false;
  }
  return true;
}

}  // namespace glide::gl_limits
