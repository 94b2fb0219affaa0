#version 310 es
// The paper's plan, second of three kernels of an iteration: the points' right-hand sides, by a tree.
//   in   buffer 0    PaperTerm per point
//        buffer 2    AlignState: the patch error of the evaluation before
//   out  buffer 1    PaperTotal
//   one workgroup of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#define TREE_SUMS 10
#include "align_types.glsl"
#include "paper_types.glsl"
#include "paper_tree.glsl"
layout(std430, binding = 0) readonly buffer Terms { PaperTerm terms[]; };
layout(std430, binding = 1) writeonly buffer Total { PaperTotal total; };
layout(std430, binding = 2) readonly buffer State { AlignState state; };
layout(location = 0) uniform int point_count;

void main() {
  int i = int(gl_LocalInvocationID.x);
  // Inliers count by the mean error of the evaluation before: this one's is not known yet.
  float threshold = max(constants.robust.x * state.photometric.z, constants.robust.y);
  vec4 b_head = vec4(0.0);
  vec4 rest = vec4(0.0);  // b 4 5, errors, contrasts
  vec2 counts = vec2(0.0);
  for (int point = i; point < point_count; point += GROUP_SIZE) {
    PaperTerm term = terms[point];
    if (term.rest.z < 0.0) continue;
    b_head += term.b_head;
    rest += term.rest;
    counts += vec2(1.0, term.rest.z <= threshold ? 1.0 : 0.0);
  }
  for (int k = 0; k < 4; ++k) partial[k][i] = b_head[k];
  for (int k = 0; k < 4; ++k) partial[4 + k][i] = rest[k];
  partial[8][i] = counts.x;
  partial[9][i] = counts.y;
  reduceTree();
  if (i != 0) return;
  for (int k = 0; k < 6; ++k) total.b[k] = partial[k][0];
  total.error = partial[6][0];
  total.contrast = partial[7][0];
  total.visible = partial[8][0];
  total.inliers = partial[9][0];
}
