#pragma once

#include <GLES3/gl31.h>

namespace glide::gl_limits {

/// Whether the compute shaders attached to `program` need no more shared memory than the floor.
/// OpenGL ES does not tell how much a program uses. So this links another program, of the same text
/// and as much more shared memory as the driver has beyond the floor, and asks whether that links.
bool sharedMemoryFits(GLuint program);

}  // namespace glide::gl_limits
