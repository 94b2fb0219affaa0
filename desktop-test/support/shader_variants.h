#pragma once

#include "gpu/shader_source.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glide::test {

/// A shader of shaders/ with the defines that the library may give it.
struct ShaderVariant {
  std::string_view shader;
  ShaderDefines defines;
};

/// Every variant that the library can build, over the patch sizes that we measure: what
/// glslangValidator and the compilers of mobile GPUs see. A new shader needs a line in the list.
std::vector<ShaderVariant> shaderVariants();

/// "align_solve.comp GROUP_SIZE=64 PATCH_SIZE=11".
std::string variantName(const ShaderVariant& variant);

/// Whether `name` is a stage of its own (.comp, .vert, .frag) rather than a file that others
/// include.
bool isShaderStage(std::string_view name);

/// The stages of `library` that the list lacks, and what the list names in vain.
std::vector<std::string> missingVariants(std::span<const EmbeddedShader> library);

}  // namespace glide::test
