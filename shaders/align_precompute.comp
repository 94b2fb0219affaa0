#version 310 es
// Inverse-compositional cache of the reference at one level (photometric-alignment.md, "Per reference and
// level"): template, gradients and their sums per point, and the two rows of the pose Jacobian.
//   in   buffer 0    points in the reference camera (xyz, w unused)
//        texture 0   the reference's level, r32f
//   out  buffer 1    PointRecord per point
//        buffer 2    e, gx, gy per pixel, in pairs (pairIndex)
//   one invocation per point, groups of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "patch.glsl"
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) writeonly buffer Records { PointRecord records[]; };
layout(std430, binding = 2) writeonly buffer Pixels { float pixels[]; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;
#include "reference_patch.glsl"

// What the patch sums up to, for the record.
float m0;
vec3 square_and_along = vec3(0.0);  // E, Ex, Ey
vec4 gradients = vec4(0.0);         // Gx, Gy, Gxx, Gxy
float gyy = 0.0;
int first_pair;  // index of e of the first pair

void visitPixel(int row, int column, float i0, vec2 gradient) {
  float e = i0 - m0;
  int stride = 2 * constants.limits.x;
  int pair = first_pair + (row * kRowPairs + column / 2) * 3 * constants.limits.x;
  int index = 2 * pair + column % 2;
  pixels[index] = e;
  pixels[index + stride] = gradient.x;
  pixels[index + 2 * stride] = gradient.y;
  square_and_along += e * vec3(e, gradient);
  gradients += vec4(gradient, gradient.x * gradient);
  gyy += gradient.y * gradient.y;
}

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count) return;
  vec3 p_ref = points[point].xyz;
  Projected projected = projectPoint(p_ref, levelScale(level));
  vec2 size = vec2(textureSize(level_image, 0));
  bool valid = projected.ok &&
               isInside(projected.uv, float(kHalfPatch + 1), size, float(kHalfPatch + 2));

  // dpi/dX [ I | -[X]x ]: the rotation part of a row j is X x j. Stored before the patch is walked, which takes
  // all registers.
  int at = recordIndex(level, point);
  vec3 wx = cross(p_ref, projected.J_u);
  vec3 wy = cross(p_ref, projected.J_v);
  records[at].p_ref = vec4(p_ref, valid ? 1.0 : 0.0);
  records[at].jx_head = vec4(projected.J_u, wx.x);
  records[at].jx_jy = vec4(wx.yz, projected.J_v.xy);
  records[at].jy_tail = vec4(projected.J_v.z, wy);
  if (valid) {
    m0 = patchMean(projected.uv);
    first_pair = pairIndex(level, point, 0, 0, 0);
    walkPatch(projected.uv);
  }
  records[at].moments = valid ? vec4(m0, square_and_along) : vec4(0.0);
  records[at].gradients = gradients;
  records[at].rest = vec4(gyy, 0.0, 0.0, 0.0);
}
