#include "render/render_program.h"

#include "gpu/program_build.h"
#include "gpu/shader_source.h"

#include <string>

namespace glide {
namespace {

Result<GlShader> buildStage(GLenum stage, const std::string& name) {
  const Result<std::string> text = assembleShader(embeddedShaders(), name, {});
  if (!text) return text.error();
  return compileShader(stage, name, *text);
}

}  // namespace

Result<GlProgram> buildRenderProgram(std::string_view name, std::string_view fragment_name) {
  const Result<GlShader> vertex = buildStage(GL_VERTEX_SHADER, std::string(name) + ".vert");
  if (!vertex) return vertex.error();
  const Result<GlShader> fragment =
      buildStage(GL_FRAGMENT_SHADER, std::string(fragment_name) + ".frag");
  if (!fragment) return fragment.error();
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), vertex->get());
  glAttachShader(program.get(), fragment->get());
  if (Status linked = linkProgram(name, program); !linked) return linked.error();
  return program;
}

}  // namespace glide
