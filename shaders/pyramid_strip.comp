#version 310 es
// One pyramid level from the next finer one: 5-tap binomial blur in x and y, border clamped, and
// decimation by two, fused (the blurred full level is never stored). An invocation makes a strip of
// two columns and `strip_rows` rows and keeps the sums of blurred rows in registers: 2.5 fetches of four
// texels an output when a strip has eight rows. No shared memory and no barrier, which software
// drivers pay dearly for.
//   in   texture 0   finer level, r32f
//   out  image 0     coarser level, r32f, size (w + 1) / 2 x (h + 1) / 2
//   one invocation per two columns and strip_rows rows, groups of 32 x GROUP_ROWS
#include "common.glsl"
#include "pyramid_quad.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0, r32f) writeonly uniform image2D coarser;
layout(location = 0) uniform int strip_rows;

// Weights 1 4 6 4 1, not normalised, around the columns at.x + 2 and at.x + 4 of row at.y (`upper`)
// and of the row below it (`lower`).
void blurTwoRows(ivec2 at, out vec2 upper, out vec2 lower) {
  vec4 a = quad(at);
  vec4 b = quad(at + ivec2(2, 0));
  vec4 c = quad(at + ivec2(4, 0));
  vec4 d = quad(at + ivec2(6, 0));
  upper = vec2(a.w + c.w, b.w + d.w) + 4.0 * (vec2(a.z, b.z) + vec2(b.z, c.z)) +
          6.0 * vec2(b.w, c.w);
  lower = vec2(a.x + c.x, b.x + d.x) + 4.0 * (vec2(a.y, b.y) + vec2(b.y, c.y)) +
          6.0 * vec2(b.x, c.x);
}

void main() {
  ivec2 size = imageSize(coarser);
  texel = 1.0 / vec2(textureSize(finer, 0));
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) * ivec2(2, strip_rows);
  if (any(greaterThanEqual(at, size))) return;

  ivec2 next = 2 * at - 2;
  vec2 upper, lower;
  blurTwoRows(next, upper, lower);
  vec2 first = upper + 4.0 * lower;  // what the last two rows give to the next output
  next.y += 2;
  blurTwoRows(next, upper, lower);
  vec2 sum = first + 6.0 * upper + 4.0 * lower;  // of an output, all but its lowest row
  first = upper + 4.0 * lower;
  int end = min(at.y + strip_rows, size.y);
  for (; at.y < end; ++at.y) {
    next.y += 2;
    blurTwoRows(next, upper, lower);
    sum += upper;
    imageStore(coarser, at, vec4(sum.x / 256.0));
    // Of an odd width the last strip has one column; a store outside of an image does nothing.
    imageStore(coarser, at + ivec2(1, 0), vec4(sum.y / 256.0));
    sum = first + 6.0 * upper + 4.0 * lower;
    first = upper + 4.0 * lower;
  }
}
