#version 310 es
// Shapes over the camera's picture (render/camera_ink.h), one an instance, four vertices each: a strip.
precision highp float;
layout(location = 0) in vec4 ab;      // stroke: both ends, px; quad: the first two corners
layout(location = 1) in vec4 cd;      // stroke: radius and that of a hole, px; quad: the other two corners
layout(location = 2) in vec4 color_0;
layout(location = 3) in vec4 color_1;
layout(location = 4) in vec4 color_2;
layout(location = 5) in vec4 color_3;
layout(location = 6) in uint kind;    // 0: stroke, 1: quad
layout(location = 0) uniform vec2 size;  // of the picture's rectangle, px
layout(location = 0) out vec4 color;
layout(location = 1) out vec2 local;       // stroke: px along from its first end, and across
layout(location = 2) flat out vec3 shape;  // stroke: length, radius, radius of the hole; quad: length -1
const float kSoftPx = 1.0;  // room around a stroke for its soft rim

void strokeCorner(vec2 corner, out vec2 at) {
  vec2 to_end = ab.zw - ab.xy;
  float len = length(to_end);
  vec2 along = len > 0.0 ? to_end / len : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = cd.x + kSoftPx;
  local = vec2(mix(-reach, len + reach, corner.x), mix(-reach, reach, corner.y));
  at = ab.xy + local.x * along + local.y * across;
  shape = vec3(len, cd.xy);
  color = corner.x > 0.5 ? color_1 : color_0;
}

void main() {
  int i = gl_VertexID;
  vec2 at;
  if (kind == 1u) {
    at = i < 2 ? (i == 0 ? ab.xy : ab.zw) : (i == 2 ? cd.xy : cd.zw);
    color = i < 2 ? (i == 0 ? color_0 : color_1) : (i == 2 ? color_2 : color_3);
    local = vec2(0.0);
    shape = vec3(-1.0, 0.0, 0.0);
  } else {
    strokeCorner(vec2(float(i & 1), float(i >> 1)), at);
  }
  gl_Position = vec4(2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y, 0.0, 1.0);
}
