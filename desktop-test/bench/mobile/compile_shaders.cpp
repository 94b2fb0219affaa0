// Compiles the library's shader variants with the GL driver at hand and passes on what its compiler
// says. Runs on the real drivers of mobile GPUs over a GPU that is not there
// (scripts/mobile_compilers.sh), so nothing is ever drawn.
//
// usage: compile_shaders GLOB      shaders whose file name matches
// Standard error: "@gpu NAME", then per variant "@variant NAME" and what the driver prints
// meanwhile; KHR_debug messages as "@message TEXT". Ends with 1 when a shader has no variants, does
// not compile, or there is no context.
#include "support/shader_variants.h"

#include "gpu/shader_source.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>

#include <cstdio>
#include <fnmatch.h>
#include <string>
#include <string_view>
#include <vector>

namespace glide {
/// The yardstick, plain.comp. Generated.
std::span<const EmbeddedShader> yardsticks();
}  // namespace glide

using glide::EmbeddedShader;
using glide::ShaderDefines;
using glide::test::ShaderVariant;

namespace {

/// The drivers write their disassembly to standard output or error: the order must stay.
void say(const char* tag, std::string_view text) {
  std::fflush(stdout);
  std::fprintf(stderr, "@%s %.*s\n", tag, static_cast<int>(text.size()), text.data());
}

/// GLDEBUGPROC.
// NOLINTNEXTLINE(readability-function-size)
void GL_APIENTRY
passOn(GLenum, GLenum, GLuint, GLenum, GLsizei length, const GLchar* text, const void*) {
  say("message", {text, static_cast<std::size_t>(length)});
}

/// A debug context without a surface, current. panfrost refuses the context attributes of EGL 1.5.
bool makeContext() {
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return false;
  eglBindAPI(EGL_OPENGL_ES_API);
  const EGLint attributes[] = {EGL_CONTEXT_CLIENT_VERSION,
                               3,
                               EGL_CONTEXT_FLAGS_KHR,
                               EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                               EGL_NONE};
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  return context != EGL_NO_CONTEXT &&
         eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

/// freedreno's statistics come this way; synchronous output would switch them off.
void listen() {
  const auto listen_to = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(
      eglGetProcAddress("glDebugMessageCallbackKHR"));
  glEnable(GL_DEBUG_OUTPUT);
  if (listen_to != nullptr) listen_to(passOn, nullptr);
}

bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

GLenum stageOf(std::string_view shader) {
  if (endsWith(shader, ".comp")) return GL_COMPUTE_SHADER;
  return endsWith(shader, ".vert") ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
}

/// A program of this stage alone, so that a fragment shader needs no partner.
bool compile(const ShaderVariant& variant, std::span<const EmbeddedShader> library) {
  const glide::Result<std::string> text =
      glide::assembleShader(library, variant.shader, variant.defines);
  if (!text) {
    say("error", text.error().message);
    return false;
  }
  const GLchar* source = text->c_str();
  const GLuint program = glCreateShaderProgramv(stageOf(variant.shader), 1, &source);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return true;
  GLchar log[1000] = "";
  glGetProgramInfoLog(program, sizeof(log), nullptr, log);
  say("error", log);
  return false;
}

int compileMatching(const char* glob) {
  int failures = 0;
  for (const std::string& missing : glide::test::missingVariants(glide::embeddedShaders())) {
    say("error", missing);
    ++failures;
  }
  const auto build = [&](const ShaderVariant& variant, std::span<const EmbeddedShader> library) {
    say("variant", glide::test::variantName(variant));
    if (!compile(variant, library)) ++failures;
  };
  for (const ShaderVariant& variant : glide::test::shaderVariants()) {
    if (::fnmatch(glob, std::string(variant.shader).c_str(), 0) == 0) {
      build(variant, glide::embeddedShaders());
    }
  }
  for (const int group_size : {32, 64, 128}) {  // GpuTuning::group_size
    build({"plain.comp", {{"GROUP_SIZE", group_size}}}, glide::yardsticks());
  }
  return failures;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: compile_shaders GLOB\n", stderr);
    return 1;
  }
  if (!makeContext()) {
    std::fprintf(stderr,
                 "@error no OpenGL ES 3 context (EGL error 0x%x)\n",
                 static_cast<unsigned>(eglGetError()));
    return 1;
  }
  say("gpu", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  listen();
  return compileMatching(arguments[1]) == 0 ? 0 : 1;
}
