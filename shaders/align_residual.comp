#version 310 es
// First half of one iteration: samples the frame at every point's patch and sums up what the solve needs
// (photometric-alignment.md, "Per iteration", S1 S2 Sc Sx Sy).
//   in   buffer 0    PointRecord per point
//        buffer 1    e, gx, gy per pixel, in pairs
//        buffer 3    AlignState: pose, whether this level has ended
//        texture 0   the frame's level, r32f
//   out  buffer 2    PointSums per point: the sums and whether it is visible
//   one invocation per point, groups of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "patch.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer Records { PointRecord records[]; };
layout(std430, binding = 1) readonly buffer Pixels { vec2 pixels[]; };
layout(std430, binding = 2) writeonly buffer Sums { PointSums sums[]; };
layout(std430, binding = 3) readonly buffer State { AlignState state; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;
#include "align_point.glsl"

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count || state.counts.w != 0 || state.flow.x == level) return;
  sumPoint(point, state.q_cam_ref, state.t_cam_ref.xyz);
}
