#version 310 es
// The paper's plan, cache of one level (its section III-C, "Precompute"): I0 and J of every pixel, and H of every
// point.
//   in   buffer 0    points in the reference camera (xyz, w unused)
//        texture 0   the reference's level, r32f
//   out  buffer 1    per level and point: X, and the contrast of the patch, negative when it leaves the level
//        buffer 2    I0, J 0..5 per pixel (sliceIndex)
//        buffer 3    H of the point, kHessianFloats each, this level only
//   one invocation per point, groups of GROUP_SIZE
#include "common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "align_types.glsl"
#include "camera.glsl"
#include "paper_types.glsl"
#include "patch.glsl"
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) writeonly buffer LevelPoints { vec4 level_points[]; };
layout(std430, binding = 2) writeonly buffer Cache { float cache[]; };
layout(std430, binding = 3) writeonly buffer Hessians { float hessians[]; };
layout(binding = 0) uniform sampler2D level_image;
layout(location = 0) uniform int point_count;
layout(location = 1) uniform int level;
#include "reference_patch.glsl"

float jx[6], jy[6];
float H[21];
float mean;
float squares = 0.0;
int slice;

void visitPixel(int row, int column, float i0, vec2 gradient) {
  int at = slice + (row * PATCH_SIZE + column) * kSlice;
  cache[at] = i0;
  float J[6];
  int h = 0;
  for (int r = 0; r < 6; ++r) {
    J[r] = gradient.x * jx[r] + gradient.y * jy[r];
    cache[at + 1 + r] = J[r];
    for (int c = 0; c <= r; ++c) H[h++] += J[r] * J[c];
  }
  squares += (i0 - mean) * (i0 - mean);
}

// The rows of dpi/dX [ I | -[X]x ]: the rotation part of a row j is X x j.
void setRows(vec3 p_ref, Projected projected) {
  vec3 wx = cross(p_ref, projected.J_u);
  vec3 wy = cross(p_ref, projected.J_v);
  for (int i = 0; i < 3; ++i) {
    jx[i] = projected.J_u[i];
    jx[3 + i] = wx[i];
    jy[i] = projected.J_v[i];
    jy[3 + i] = wy[i];
  }
}

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count) return;
  vec3 p_ref = points[point].xyz;
  Projected projected = projectPoint(p_ref, levelScale(level));
  vec2 size = vec2(textureSize(level_image, 0));
  bool valid = projected.ok &&
               isInside(projected.uv, float(kHalfPatch + 1), size, float(kHalfPatch + 2));
  for (int h = 0; h < 21; ++h) H[h] = 0.0;
  if (valid) {
    setRows(p_ref, projected);
    slice = sliceIndex(level, point);
    mean = patchMean(projected.uv);
    walkPatch(projected.uv);
  }
  float contrast = valid ? sqrt(squares / float(kPatchPixels)) : -1.0;
  level_points[recordIndex(level, point)] = vec4(p_ref, contrast);
  int first = point * kHessianFloats;
  for (int h = 0; h < 21; ++h) hessians[first + h] = H[h];
  hessians[first + 21] = valid ? 1.0 : 0.0;
  hessians[first + 22] = 0.0;
  hessians[first + 23] = 0.0;
}
