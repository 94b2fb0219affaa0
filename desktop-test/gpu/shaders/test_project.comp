#version 310 es
// Test of camera.glsl: projects points.
//   in   buffer 0   points (xyz, scale)
//   out  buffer 1   per point: (ok, u, v, 0), (J_u, 0), (J_v, 0)
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) writeonly buffer Results { vec4 results[]; };
layout(location = 0) uniform int point_count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= point_count) return;
  Projected projected = projectPoint(points[i].xyz, points[i].w);
  results[3 * i] = vec4(projected.ok ? 1.0 : 0.0, projected.uv, 0.0);
  results[3 * i + 1] = vec4(projected.J_u, 0.0);
  results[3 * i + 2] = vec4(projected.J_v, 0.0);
}
