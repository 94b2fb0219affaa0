#version 310 es
// Second pass of the paper's pyramid: 5-tap binomial blur along the columns of what
// pyramid_blur_rows.comp has made of a level, at its even pixels only: the next level.
//   in   texture 0   the temporary texture, r32f; its upper left part is the level
//   out  image 0     coarser level, r32f, size (w + 1) / 2 x (h + 1) / 2
//   one invocation per pixel of the coarser level, groups of 32 x GROUP_ROWS
#include "common.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0) uniform sampler2D blurred;
layout(binding = 0, r32f) writeonly uniform image2D coarser;
layout(location = 0) uniform int finer_height;

float at(int x, int y) { return texelFetch(blurred, ivec2(x, y), 0).r; }

void main() {
  ivec2 out_at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(out_at, imageSize(coarser)))) return;
  int x = 2 * out_at.x;
  int y = 2 * out_at.y;
  int last = finer_height - 1;
  float outer = at(x, max(y - 2, 0)) + at(x, min(y + 2, last));
  float inner = at(x, max(y - 1, 0)) + at(x, min(y + 1, last));
  float sum = outer + 4.0 * inner + 6.0 * at(x, y);
  imageStore(coarser, out_at, vec4(sum / 16.0));
}
