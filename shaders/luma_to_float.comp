#version 310 es
// Level 0 of the pyramid: grey levels 0..255 of an 8-bit image as floats.
//   in   texture 0   luma, r8ui
//   out  image 0     level 0, r32f
//   one invocation per pixel, groups of 32 x GROUP_ROWS
#include "common.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0) uniform usampler2D luma;
layout(binding = 0, r32f) writeonly uniform image2D level0;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(level0)))) return;
  imageStore(level0, at, vec4(float(texelFetch(luma, at, 0).r)));
}
