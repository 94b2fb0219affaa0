#version 310 es
// Test of rigid.glsl.
//   in   buffer 0   per item: twist (v, 0), (w, 0), point (xyz, 0)
//   out  buffer 1   per item: exp(twist) as quaternion xyzw and translation, and exp(twist) * point
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer Items { vec4 items[]; };
layout(std430, binding = 1) writeonly buffer Results { vec4 results[]; };
layout(location = 0) uniform int item_count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= item_count) return;
  vec4 q;
  vec3 t;
  expTwist(items[3 * i].xyz, items[3 * i + 1].xyz, q, t);
  results[3 * i] = q;
  results[3 * i + 1] = vec4(t, 0.0);
  results[3 * i + 2] = vec4(rotate(q, items[3 * i + 2].xyz) + t, 0.0);
}
