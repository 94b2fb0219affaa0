// Included by the kernels that make a pyramid level in one dispatch: the finer level, 2 x 2 texels a fetch.
//   in   texture 0   finer level, r32f, unfiltered, clamped to its edge
layout(binding = 0) uniform sampler2D finer;

vec2 texel;  // size of a texel in texture coordinates; main() sets it

// The texels `at` (w), one right (z), one down (x) and both (y): textureGather's order. The coordinate
// is where the four meet, half a texel away from any rounding; texels outside are those of the border.
vec4 quad(ivec2 at) { return textureGather(finer, vec2(at + 1) * texel); }
