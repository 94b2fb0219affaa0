#version 310 es
// All iterations of one level in ONE workgroup: align_residual.comp and align_solve.comp in a loop. For
// levels where a dispatch and a barrier cost more than the work.
//   in      buffer 0    PointRecord per point
//           buffer 1    e, gx, gy per pixel, in pairs
//           texture 0   the frame's level, r32f
//   in/out  buffer 2    PointSums per point
//           buffer 3    AlignState
//   one workgroup of GROUP_SIZE
//   shared 16.1 kB at 128 invocations
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "patch.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer Records { PointRecord records[]; };
layout(std430, binding = 1) readonly buffer Pixels { vec2 pixels[]; };
layout(std430, binding = 2) buffer Sums { PointSums sums[]; };
layout(std430, binding = 3) buffer State { AlignState state; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;
layout(location = 2) uniform int all_points;
layout(location = 3) uniform int max_iterations;
#include "align_equations.glsl"
#include "align_point.glsl"

// What the first invocation tells the others after an iteration.
shared vec4 q_cam_ref;
shared vec4 t_cam_ref_and_end;  // w: 1 when the level has ended

void publish() {
  if (gl_LocalInvocationID.x == 0u) {
    bool ended = state.counts.w != 0 || state.flow.x == level;
    q_cam_ref = state.q_cam_ref;
    t_cam_ref_and_end = vec4(state.t_cam_ref.xyz, ended ? 1.0 : 0.0);
  }
  memoryBarrierShared();
  barrier();
}

void main() {
  has_weights = state.flow.y != 0;
  publish();
  for (int k = 0; k < max_iterations && t_cam_ref_and_end.w == 0.0; ++k) {
    for (int i = int(gl_LocalInvocationID.x); i < point_count; i += GROUP_SIZE) {
      sumPoint(i, q_cam_ref, t_cam_ref_and_end.xyz);
    }
    if (!iterate()) return;
    has_weights = true;
    publish();
  }
}
