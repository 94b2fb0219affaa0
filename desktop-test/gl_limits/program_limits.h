#pragma once

#include <GLES3/gl31.h>

#include <string>

namespace glide::gl_limits {

/// What a linked program uses beyond the floors, "5 storage blocks (of 4); ..."; empty when
/// nothing.
std::string usesBeyondFloors(GLuint program);

}  // namespace glide::gl_limits
