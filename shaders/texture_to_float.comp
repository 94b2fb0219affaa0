#version 310 es
// Level 0 of the pyramid: grey levels 0..255 of a frame in an app's texture.
//   in   texture 0   see texture_source.glsl
//   out  image 0     level 0, r32f
//   one invocation per pixel, groups of 32 x GROUP_ROWS
#if EXTERNAL_TEXTURE
#extension GL_OES_EGL_image_external_essl3 : require
#endif
#include "common.glsl"
#include "texture_source.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0, r32f) writeonly uniform image2D level0;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(level0)))) return;
  imageStore(level0, at, vec4(greyAt(at)));
}
