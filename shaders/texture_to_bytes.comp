#version 310 es
// Grey levels of a frame in an app's texture as bytes, for the CPU: four pixels a word, the first in the lowest byte.
//   in   texture 0   see texture_source.glsl
//   out  buffer 0    words_per_row words a row; what lies behind the end of a row is its last pixel or beyond
//   one invocation per word, groups of 32 x GROUP_ROWS
#if EXTERNAL_TEXTURE
#extension GL_OES_EGL_image_external_essl3 : require
#endif
#include "common.glsl"
#include "texture_source.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(location = 4) uniform ivec2 words;  // per row, and rows
layout(binding = 0, std430) writeonly buffer Bytes { uint bytes[]; };

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, words))) return;
  uint word = 0u;
  for (int i = 3; i >= 0; --i) word = (word << 8) | uint(greyAt(ivec2(4 * at.x + i, at.y)));
  bytes[at.y * words.x + at.x] = word;
}
