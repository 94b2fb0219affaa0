#pragma once

#include "gpu/gl_objects.h"
#include "gpu/program_cache.h"
#include "gpu/shader_source.h"

#include <string>
#include <string_view>

namespace glide {

/// A compute shader of shaders/, compiled and linked. Owned by the GL thread.
class ComputeProgram {
 public:
  /// Takes shaders/`name` from `programs`, or builds it and leaves its binary there. An error holds
  /// the driver's log.
  static Result<ComputeProgram> create(std::string_view name,
                                       const ShaderDefines& defines,
                                       const ProgramCache& programs);
  /// The same, always built.
  static Result<ComputeProgram> create(std::string_view name, const ShaderDefines& defines);
  /// Builds from a text that assembleShader made; `name` is for messages.
  static Result<ComputeProgram> compile(std::string_view name, const std::string& text);

  void use() const { glUseProgram(program_.get()); }
  GLuint get() const { return program_.get(); }
  void abandon() { program_.abandon(); }

 private:
  static Result<ComputeProgram> build(std::string_view name,
                                      const std::string& text,
                                      const ProgramCache& programs);
  explicit ComputeProgram(GlProgram program) : program_(std::move(program)) {}
  GlProgram program_;
};

/// local_size_x of the kernels that go over an image; GROUP_ROWS is their local_size_y.
inline constexpr int kGroupWidth = 32;

/// Workgroups of `group_size` that cover `items`.
inline GLuint groupCount(int items, int group_size) {
  return static_cast<GLuint>((items + group_size - 1) / group_size);
}

}  // namespace glide
