#pragma once

#include "glide/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glide {

/// One file of shaders/, embedded at build time (cmake/GlideShaders.cmake).
struct EmbeddedShader {
  std::string_view name;  ///< file name, for instance "align_solve.comp"
  std::string_view text;
};

/// All files of shaders/. Defined by the generated source.
std::span<const EmbeddedShader> embeddedShaders();

/// An integer that a shader takes as a #define.
struct ShaderDefine {
  std::string name;
  int value = 0;
};
using ShaderDefines = std::vector<ShaderDefine>;

/// The compilable text of shader `name`: its #version line, then the defines, then the rest with
/// each
/// `#include "file"` line replaced by that file of the library. internal when a file is not there.
Result<std::string> assembleShader(std::span<const EmbeddedShader> library,
                                   std::string_view name,
                                   const ShaderDefines& defines);

}  // namespace glide
