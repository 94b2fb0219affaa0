#version 310 es
// A round point with a soft edge.
precision highp float;

flat in vec4 point_color;
flat in float point_px;
layout(location = 0) out vec4 color;

void main() {
  float from_center_px = length(gl_PointCoord - 0.5) * (point_px + 1.0);
  float coverage = clamp(0.5 * point_px + 0.5 - from_center_px, 0.0, 1.0);
  if (coverage <= 0.0) discard;  // leaves no depth
  color = vec4(point_color.rgb, point_color.a * coverage);
}
