#include "gpu/compute_program.h"

#include "gpu/program_build.h"

namespace glide {

Result<ComputeProgram> ComputeProgram::create(std::string_view name,
                                              const ShaderDefines& defines,
                                              const ProgramCache& programs) {
  const Result<std::string> text = assembleShader(embeddedShaders(), name, defines);
  if (!text) return text.error();
  if (std::optional<GlProgram> kept = programs.load(*text)) return ComputeProgram(std::move(*kept));
  Result<ComputeProgram> built = build(name, *text, programs);
  if (built) programs.store(*text, built->program_);
  return built;
}

Result<ComputeProgram> ComputeProgram::create(std::string_view name, const ShaderDefines& defines) {
  return create(name, defines, ProgramCache());
}

Result<ComputeProgram> ComputeProgram::compile(std::string_view name, const std::string& text) {
  return build(name, text, ProgramCache());
}

Result<ComputeProgram> ComputeProgram::build(std::string_view name,
                                             const std::string& text,
                                             const ProgramCache& programs) {
  const Result<GlShader> shader = compileShader(GL_COMPUTE_SHADER, name, text);
  if (!shader) return shader.error();
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), shader->get());
  programs.prepare(program);
  if (Status linked = linkProgram(name, program); !linked) return linked.error();
  return ComputeProgram(std::move(program));
}

}  // namespace glide
