#version 310 es
// Inside of a shape (render_camera_ink.vert); strokes have a rim of one pixel that is part of it.
precision highp float;
layout(location = 0) in vec4 color;
layout(location = 1) in vec2 local;
layout(location = 2) flat in vec3 shape;
layout(location = 0) out vec4 fragment;

float strokeCoverage() {
  float beyond = local.x - clamp(local.x, 0.0, shape.x);
  float distance_px = length(vec2(beyond, local.y));
  return clamp(shape.y + 0.5 - distance_px, 0.0, 1.0) * clamp(distance_px - shape.z + 0.5, 0.0, 1.0);
}

void main() {
  float coverage = shape.x < 0.0 ? 1.0 : strokeCoverage();
  fragment = vec4(color.rgb, color.a * coverage);
}
