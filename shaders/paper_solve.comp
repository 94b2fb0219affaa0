#version 310 es
// The paper's plan, third of three kernels of an iteration: Cholesky with the level's constant H, and the update.
//   in      buffer 0   H of the levels
//           buffer 1   PaperTotal
//   in/out  buffer 2   AlignState
//   one invocation
#include "common.glsl"
layout(local_size_x = 1) in;
#include "align_types.glsl"
#include "paper_types.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer LevelHessians { float level_hessians[]; };
layout(std430, binding = 1) readonly buffer Total { PaperTotal sums; };
layout(std430, binding = 2) buffer State { AlignState state; };
layout(location = 1) uniform int level;

float total[27];
#include "align_step.glsl"

void main() {
  if (state.counts.w != 0) return;
  int first = level * kHessianFloats;
  ivec4 counts = ivec4(int(level_hessians[first + 21]), int(sums.visible), int(sums.inliers), 0);
  if (counts.y < constants.limits.y) {  // too few points: the level leaves the pose as it is
    if (level == 0) state.counts = ivec4(counts.xyz, 1);
    return;
  }
  for (int h = 0; h < 21; ++h) state.hessian[h] = total[h] = level_hessians[first + h];
  for (int k = 0; k < 6; ++k) total[21 + k] = sums.b[k];
  state.photometric.zw = vec2(sums.error, sums.contrast) / sums.visible;
  state.counts = counts;
  state.iterations[level] += 1;
  takeStep();
}
