#version 310 es
// Second half of one iteration, in ONE workgroup (photometric-alignment.md, "Per iteration", steps 1-7):
// gain and bias, scale, weights, normal equations, 6x6 Cholesky, pose update, end of the level.
//   in      buffer 0   PointRecord per point
//   in/out  buffer 2   PointSums per point: its weight and patch error are written
//           buffer 3   AlignState
//   one workgroup of GROUP_SIZE
//   shared 16.1 kB at 128 invocations
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer Records { PointRecord records[]; };
layout(std430, binding = 2) buffer Sums { PointSums sums[]; };
layout(std430, binding = 3) buffer State { AlignState state; };
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;
layout(location = 2) uniform int all_points;
#include "align_equations.glsl"

void main() {
  if (state.counts.w != 0 || state.flow.x == level) return;
  has_weights = state.flow.y != 0;
  iterate();
}
