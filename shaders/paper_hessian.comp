#version 310 es
// The paper's plan, H of one level: the sum of the points' H, by a tree.
//   in   buffer 0    H of the points, kHessianFloats each
//   out  buffer 1    H of the levels, kHessianFloats each
//   one workgroup of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#define TREE_SUMS 22
#include "align_types.glsl"
#include "paper_types.glsl"
#include "paper_tree.glsl"
layout(std430, binding = 0) readonly buffer PointHessians { float point_hessians[]; };
layout(std430, binding = 1) buffer LevelHessians { float level_hessians[]; };
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;

void main() {
  int i = int(gl_LocalInvocationID.x);
  float part[TREE_SUMS];
  for (int k = 0; k < TREE_SUMS; ++k) part[k] = 0.0;
  for (int point = i; point < point_count; point += GROUP_SIZE) {
    for (int k = 0; k < TREE_SUMS; ++k) part[k] += point_hessians[point * kHessianFloats + k];
  }
  for (int k = 0; k < TREE_SUMS; ++k) partial[k][i] = part[k];
  reduceTree();
  if (i != 0) return;
  for (int k = 0; k < TREE_SUMS; ++k) level_hessians[level * kHessianFloats + k] = partial[k][0];
}
