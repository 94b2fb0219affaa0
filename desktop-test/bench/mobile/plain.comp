#version 310 es
// The yardstick of ./glide bench mobile-compilers, not part of the library: photometric residuals of 11 x 11
// patches as one writes them down first. Filtered samples, gradients by central differences at every pixel,
// residuals stored, no robust weight and no factored Jacobian.
//   in   buffer 0    centre of the patch in the reference and in the frame, px
//        texture 0   frame, texture 1: reference
//   out  buffer 1    residual per pixel
//        buffer 2    sum of squares and of gradient products per point
//   one invocation per point, groups of GROUP_SIZE
precision highp float;
precision highp int;
precision highp sampler2D;
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 0) readonly buffer Centres { vec4 centre_ref_cam[]; };
layout(std430, binding = 1) writeonly buffer Residuals { float residuals[]; };
layout(std430, binding = 2) writeonly buffer Sums { float sums[]; };
layout(binding = 0) uniform sampler2D frame;
layout(binding = 1) uniform sampler2D reference;
layout(location = 0) uniform int point_count;

const uint kPatchSize = 11u;
const uint kPatchPixels = kPatchSize * kPatchSize;

void main() {
  int point = int(gl_GlobalInvocationID.x);
  if (point >= point_count) return;
  vec4 centre = centre_ref_cam[point];
  vec2 pixel = 1.0 / vec2(textureSize(frame, 0));
  float squares = 0.0;
  float along_x = 0.0;
  float along_xy = 0.0;
  for (uint k = 0u; k < kPatchPixels; ++k) {
    vec2 offset = vec2(float(k % kPatchSize), float(k / kPatchSize)) - float(kPatchSize / 2u);
    float expected = texelFetch(reference, ivec2(centre.xy + offset), 0).r;
    vec2 at = (centre.zw + offset + 0.5) * pixel;
    vec2 right = vec2(pixel.x, 0.0);
    vec2 down = vec2(0.0, pixel.y);
    float gx = textureLod(frame, at + right, 0.0).r - textureLod(frame, at - right, 0.0).r;
    float gy = textureLod(frame, at + down, 0.0).r - textureLod(frame, at - down, 0.0).r;
    float residual = textureLod(frame, at, 0.0).r - expected;
    residuals[uint(point) * kPatchPixels + k] = residual;
    squares += residual * residual;
    along_x += gx * gx;
    along_xy += (gx + gy) * residual;
  }
  sums[point] = squares + along_x + along_xy;
}
