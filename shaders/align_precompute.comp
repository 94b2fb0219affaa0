#version 310 es
// Inverse-compositional cache of the reference at one level (photometric-alignment.md, "Per reference and
// level"): template, gradients and their sums per point, and the two rows of the pose Jacobian.
//   in   buffer 0    points in the reference camera (xyz, w unused)
//        texture 0   the reference's level, r32f
//   out  buffer 1    PointRecord per point
//        buffer 2    e, gx, gy per pixel (pixelIndex)
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

const int kWide = PATCH_SIZE + 2;  // the patch and one pixel around it, for the central differences

// Mean of the patch whose first texel is `first`.
float patchMean(ivec2 first, vec2 fraction) {
  float row[PATCH_SIZE];
  float sum = 0.0;
  for (int y = 0; y <= PATCH_SIZE; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y), fraction.x, row, PATCH_SIZE)
    float weight = y == 0 ? 1.0 - fraction.y : (y == PATCH_SIZE ? fraction.y : 1.0);
    float row_sum = 0.0;
    for (int x = 0; x < PATCH_SIZE; ++x) row_sum += row[x];
    sum += weight * row_sum;
  }
  return sum / float(kPatchPixels);
}

void storePixel(int point, int k, vec3 e_gx_gy) {
  for (int c = 0; c < 3; ++c) pixels[pixelIndex(level, point, k, c)] = e_gx_gy[c];
}

// Writes the pixels of a valid patch and returns its sums in the fields of the record.
void describePatch(int point, vec2 uv, inout PointRecord record) {
  ivec2 texel = ivec2(floor(uv));
  vec2 fraction = uv - vec2(texel);
  float m0 = patchMean(texel - kHalfPatch, fraction);

  // Interpolated rows y-1, y, y+1 of the widened patch; `upper` and `lower` are texel rows.
  float before[kWide], here[kWide], after[kWide], upper[kWide], lower[kWide];
  ivec2 first = texel - kHalfPatch - 1;
  SAMPLE_ROW(level_image, first, fraction.x, upper, kWide)
  for (int x = 0; x < kWide; ++x) here[x] = after[x] = 0.0;
  vec4 moments = vec4(m0, 0.0, 0.0, 0.0);
  vec4 gradients = vec4(0.0);
  float gyy = 0.0;
  for (int y = 0; y < kWide; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y + 1), fraction.x, lower, kWide)
    for (int x = 0; x < kWide; ++x) {
      before[x] = here[x];
      here[x] = after[x];
      after[x] = mix(upper[x], lower[x], fraction.y);
      upper[x] = lower[x];
    }
    if (y < 2) continue;
    for (int x = 0; x < PATCH_SIZE; ++x) {
      float e = here[x + 1] - m0;
      vec2 g = 0.5 * vec2(here[x + 2] - here[x], after[x + 1] - before[x + 1]);
      storePixel(point, (y - 2) * PATCH_SIZE + x, vec3(e, g));
      moments.yzw += vec3(e * e, g * e);
      gradients += vec4(g, g.x * g);
      gyy += g.y * g.y;
    }
  }
  record.moments = moments;
  record.gradients = gradients;
  record.rest = vec4(gyy, 0.0, 0.0, 0.0);
}

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count) return;
  vec3 p_ref = points[point].xyz;
  Projected projected = projectPoint(p_ref, levelScale(level));
  vec2 size = vec2(textureSize(level_image, 0));
  bool valid = projected.ok &&
               isInside(projected.uv, float(kHalfPatch + 1), size, float(kHalfPatch + 2));

  // dpi/dX [ I | -[X]x ]: the rotation part of a row j is X x j.
  vec3 wx = cross(p_ref, projected.J_u);
  vec3 wy = cross(p_ref, projected.J_v);
  PointRecord record;
  record.p_ref = vec4(p_ref, valid ? 1.0 : 0.0);
  record.jx_head = vec4(projected.J_u, wx.x);
  record.jx_jy = vec4(wx.yz, projected.J_v.xy);
  record.jy_tail = vec4(projected.J_v.z, wy);
  record.moments = vec4(0.0);
  record.gradients = vec4(0.0);
  record.rest = vec4(0.0);
  if (valid) describePatch(point, projected.uv, record);
  records[recordIndex(level, point)] = record;
}
