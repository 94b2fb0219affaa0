#version 310 es
// The paper's plan, first of three kernels of an iteration: the right-hand side of every point.
//   in   buffer 0    per level and point: X, contrast (negative: not valid)
//        buffer 1    I0, J 0..5 per pixel
//        buffer 3    AlignState: pose
//        texture 0   the frame's level, r32f
//   out  buffer 2    PaperTerm per point
//   one invocation per point, groups of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "paper_types.glsl"
#include "patch.glsl"
#include "rigid.glsl"
layout(std430, binding = 0) readonly buffer LevelPoints { vec4 level_points[]; };
layout(std430, binding = 1) readonly buffer Cache { float cache[]; };
layout(std430, binding = 2) writeonly buffer Terms { PaperTerm terms[]; };
layout(std430, binding = 3) readonly buffer State { AlignState state; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;

// b of a visible point, and its patch error.
PaperTerm sumPatch(int point, vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch;
  vec2 fraction = fract(uv);
  float upper[PATCH_SIZE], lower[PATCH_SIZE];
  SAMPLE_ROW(level_image, first, fraction.x, upper, PATCH_SIZE)
  vec4 b_head = vec4(0.0);
  vec2 b_tail = vec2(0.0);
  float squares = 0.0;
  int at = sliceIndex(level, point);
  for (int y = 1; y <= PATCH_SIZE; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y), fraction.x, lower, PATCH_SIZE)
    for (int x = 0; x < PATCH_SIZE; ++x) {
      float r = mix(upper[x], lower[x], fraction.y) - cache[at];
      b_head += r * vec4(cache[at + 1], cache[at + 2], cache[at + 3], cache[at + 4]);
      b_tail += r * vec2(cache[at + 5], cache[at + 6]);
      squares += r * r;
      at += kSlice;
      upper[x] = lower[x];
    }
  }
  return PaperTerm(b_head, vec4(b_tail, sqrt(squares / float(kPatchPixels)), 0.0));
}

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count) return;
  PaperTerm term = PaperTerm(vec4(0.0), vec4(0.0, 0.0, -1.0, 0.0));
  vec4 p_ref = level_points[recordIndex(level, point)];
  if (p_ref.w >= 0.0) {
    vec3 p_cam = rotate(state.q_cam_ref, p_ref.xyz) + state.t_cam_ref.xyz;
    Projected projected = projectPoint(p_cam, levelScale(level));
    vec2 size = vec2(textureSize(level_image, 0));
    if (projected.ok && isInside(projected.uv, float(kHalfPatch), size, float(kHalfPatch + 1))) {
      term = sumPatch(point, projected.uv);
      term.rest.w = p_ref.w;
    }
  }
  terms[point] = term;
}
