// A frame in an app's texture (gpu/texture_pass.h). The defines: EXTERNAL_TEXTURE 0 or 1.
//   in   texture 0   what can be sampled as floats
#include "luma_weights.glsl"
#if EXTERNAL_TEXTURE
uniform highp samplerExternalOES source;
vec3 sampleSource(vec2 uv) { return texture(source, uv).rgb; }
#else
layout(binding = 0) uniform sampler2D source;
vec3 sampleSource(vec2 uv) { return textureLod(source, uv, 0.0).rgb; }
#endif
// Sizes and places come as uniforms: textureSize() of an external texture is wrong on llvmpipe.
layout(location = 0) uniform vec2 origin;      // texture coordinates of pixel (0, 0)
layout(location = 1) uniform vec2 per_column;  // and how they change along a row
layout(location = 2) uniform vec2 per_row;     // and down a column
layout(location = 3) uniform vec3 weights;     // of greyOf

// Grey level 0..255, rounded, of pixel `at` of the frame.
float greyAt(ivec2 at) {
  return greyOf(sampleSource(origin + float(at.x) * per_column + float(at.y) * per_row), weights);
}
