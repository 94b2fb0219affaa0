#version 310 es
// First half of one iteration: samples the frame at every point's patch and sums up what the solve needs
// (photometric-alignment.md, "Per iteration", S1 S2 Sc Sx Sy).
//   in   buffer 0    PointRecord per point
//        buffer 1    e, gx, gy per pixel
//        buffer 3    AlignState: pose, whether this level has ended
//        texture 0   the frame's level, r32f
//   out  buffer 2    PointSums per point
//   one invocation per point, groups of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "patch.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer Records { PointRecord records[]; };
layout(std430, binding = 1) readonly buffer Pixels { float pixels[]; };
layout(std430, binding = 2) writeonly buffer Sums { PointSums sums[]; };
layout(std430, binding = 3) readonly buffer State { AlignState state; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;

PointSums sumPatch(int point, vec2 uv, float m0) {
  ivec2 texel = ivec2(floor(uv));
  vec2 fraction = uv - vec2(texel);
  ivec2 first = texel - kHalfPatch;
  float upper[PATCH_SIZE], lower[PATCH_SIZE];
  SAMPLE_ROW(level_image, first, fraction.x, upper, PATCH_SIZE)
  vec4 intensity = vec4(0.0);
  float sy = 0.0;
  int index = pixelIndex(level, point, 0, 0);
  int stride = constants.limits.x;
  for (int y = 1; y <= PATCH_SIZE; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y), fraction.x, lower, PATCH_SIZE)
    for (int x = 0; x < PATCH_SIZE; ++x) {
      float i = mix(upper[x], lower[x], fraction.y) - m0;
      intensity += i * vec4(1.0, i, pixels[index], pixels[index + stride]);
      sy += i * pixels[index + 2 * stride];
      index += 3 * stride;
      upper[x] = lower[x];
    }
  }
  return PointSums(intensity, vec4(sy, 1.0, 0.0, 0.0));
}

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count || state.counts.w != 0 || state.flow.x == level) return;
  int at = recordIndex(level, point);
  vec4 p_ref = records[at].p_ref;
  PointSums result = PointSums(vec4(0.0), vec4(0.0));
  if (p_ref.w > 0.5) {
    vec3 p_cam = rotate(state.q_cam_ref, p_ref.xyz) + state.t_cam_ref.xyz;
    Projected projected = projectPoint(p_cam, levelScale(level));
    vec2 size = vec2(textureSize(level_image, 0));
    if (projected.ok && isInside(projected.uv, float(kHalfPatch), size, float(kHalfPatch + 1))) {
      result = sumPatch(point, projected.uv, records[at].moments.x);
    }
  }
  sums[point] = result;
}
