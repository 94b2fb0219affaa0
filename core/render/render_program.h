#pragma once

#include "gpu/gl_objects.h"

#include "glide/result.h"

#include <string_view>

namespace glide {

/// The program of shaders/`name`.vert and shaders/`fragment_name`.frag. Attributes and uniforms
/// have the locations that the shaders give them. An error holds the driver's log.
Result<GlProgram> buildRenderProgram(std::string_view name, std::string_view fragment_name);

}  // namespace glide
