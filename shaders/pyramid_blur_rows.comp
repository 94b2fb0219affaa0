#version 310 es
// First pass of the paper's pyramid (its section III-C): 5-tap binomial blur along the rows of a full
// level into a temporary texture, border clamped. pyramid_blur_columns.comp is the second.
//   in   texture 0   level, r32f
//   out  image 0     the upper left part of the temporary texture, r32f
//   one invocation per pixel of the level, groups of 32 x GROUP_ROWS
#include "common.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0) uniform sampler2D level;
layout(binding = 0, r32f) writeonly uniform image2D blurred;

float at(int x, int y) { return texelFetch(level, ivec2(x, y), 0).r; }

void main() {
  ivec2 last = textureSize(level, 0) - 1;
  int x = int(gl_GlobalInvocationID.x);
  int y = int(gl_GlobalInvocationID.y);
  if (x > last.x || y > last.y) return;
  float outer = at(max(x - 2, 0), y) + at(min(x + 2, last.x), y);
  float inner = at(max(x - 1, 0), y) + at(min(x + 1, last.x), y);
  float sum = outer + 4.0 * inner + 6.0 * at(x, y);
  imageStore(blurred, ivec2(x, y), vec4(sum / 16.0));
}
