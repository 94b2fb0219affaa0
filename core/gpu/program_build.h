#pragma once

#include "gpu/gl_objects.h"

#include <string>
#include <string_view>

namespace glide {

/// A compiled shader of `stage` (GL_COMPUTE_SHADER and the like); `name` is for messages. An error
/// holds the driver's log.
Result<GlShader> compileShader(GLenum stage, std::string_view name, const std::string& text);

/// Links a program whose shaders are attached, and detaches them.
Status linkProgram(std::string_view name, const GlProgram& program);

}  // namespace glide
