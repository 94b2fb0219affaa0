#version 310 es
// One pyramid level from the next finer one, as pyramid_strip.comp, by workgroups that share a tile: the
// rows of the tile and its apron are blurred and decimated on the way into shared memory, then the
// columns. 3.4 fetches of four texels an output and one barrier; more of the GPU is busy on small levels
// than with strips.
//   in   texture 0   finer level, r32f
//   out  image 0     coarser level, r32f, size (w + 1) / 2 x (h + 1) / 2
//   one workgroup per 32 x 16 outputs, groups of 32 x GROUP_ROWS
//   shared 4.5 KiB
#include "common.glsl"
#include "pyramid_quad.glsl"
layout(local_size_x = 32, local_size_y = GROUP_ROWS) in;
layout(binding = 0, r32f) writeonly uniform image2D coarser;

const int kTileWidth = 32;
const int kTileHeight = 16;
const int kFinerRows = 2 * kTileHeight + 4;  // of the tile, two above, one below, and one to make it even
shared float blurred[kFinerRows * kTileWidth];

void main() {
  ivec2 size = imageSize(coarser);
  texel = 1.0 / vec2(textureSize(finer, 0));
  ivec2 origin = ivec2(gl_WorkGroupID.xy) * ivec2(kTileWidth, kTileHeight);
  int column = int(gl_LocalInvocationID.x);

  for (int row = 2 * int(gl_LocalInvocationID.y); row < kFinerRows; row += 2 * GROUP_ROWS) {
    ivec2 at = 2 * (origin + ivec2(column, 0)) - 2 + ivec2(0, row);
    vec4 a = quad(at);
    vec4 b = quad(at + ivec2(2, 0));
    vec4 c = quad(at + ivec2(4, 0));
    blurred[row * kTileWidth + column] = a.w + c.w + 4.0 * (a.z + b.z) + 6.0 * b.w;
    blurred[(row + 1) * kTileWidth + column] = a.x + c.x + 4.0 * (a.y + b.y) + 6.0 * b.x;
  }
  barrier();

  for (int y = int(gl_LocalInvocationID.y); y < kTileHeight; y += GROUP_ROWS) {
    ivec2 at = origin + ivec2(column, y);
    if (any(greaterThanEqual(at, size))) continue;
    int i = 2 * y * kTileWidth + column;
    float outer = blurred[i] + blurred[i + 4 * kTileWidth];
    float inner = blurred[i + kTileWidth] + blurred[i + 3 * kTileWidth];
    float sum = outer + 4.0 * inner + 6.0 * blurred[i + 2 * kTileWidth];
    imageStore(coarser, at, vec4(sum / 256.0));
  }
}
