#version 310 es
// One pyramid level from the next finer one: 5-tap binomial blur in x and y, border clamped, and
// decimation by two, fused (the blurred full level is never stored). An invocation makes a strip of
// STRIP_ROWS outputs and keeps the last five blurred rows in registers: 10 fetches an output, no shared
// memory and no barrier, which software drivers pay dearly for.
//   in   texture 0   finer level, r32f
//   out  image 0     coarser level, r32f, size (w + 1) / 2 x (h + 1) / 2
//   one invocation per column and STRIP_ROWS rows, groups of 32 x GROUP_ROWS
#include "common.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0) uniform sampler2D finer;
layout(binding = 0, r32f) writeonly uniform image2D coarser;

// Weights 1 4 6 4 1 around column 2x, not normalised.
float blurRow(int x, int y, ivec2 last) {
  y = clamp(y, 0, last.y);
  float outer = texelFetch(finer, ivec2(max(2 * x - 2, 0), y), 0).r +
              texelFetch(finer, ivec2(min(2 * x + 2, last.x), y), 0).r;
  float inner = texelFetch(finer, ivec2(max(2 * x - 1, 0), y), 0).r +
               texelFetch(finer, ivec2(min(2 * x + 1, last.x), y), 0).r;
  return outer + 4.0 * inner + 6.0 * texelFetch(finer, ivec2(2 * x, y), 0).r;
}

void main() {
  ivec2 size = imageSize(coarser);
  ivec2 last = textureSize(finer, 0) - 1;
  int x = int(gl_GlobalInvocationID.x);
  int y = int(gl_GlobalInvocationID.y) * STRIP_ROWS;
  if (x >= size.x || y >= size.y) return;

  float above2 = blurRow(x, 2 * y - 2, last);
  float above1 = blurRow(x, 2 * y - 1, last);
  float centre = blurRow(x, 2 * y, last);
  int end = min(y + STRIP_ROWS, size.y);
  for (; y < end; ++y) {
    float below1 = blurRow(x, 2 * y + 1, last);
    float below2 = blurRow(x, 2 * y + 2, last);
    float sum = above2 + below2 + 4.0 * (above1 + below1) + 6.0 * centre;
    imageStore(coarser, ivec2(x, y), vec4(sum / 256.0));
    above2 = centre;
    above1 = below1;
    centre = below2;
  }
}
