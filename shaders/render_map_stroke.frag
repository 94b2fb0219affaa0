#version 310 es
// A line with soft edges and round ends.
precision highp float;

in vec2 stroke_at_px;
flat in vec2 stroke_extent_px;
flat in vec4 stroke_color;
layout(location = 0) out vec4 color;

void main() {
  float nearest_px = clamp(stroke_at_px.x, 0.0, stroke_extent_px.x);
  float distance_px = length(vec2(stroke_at_px.x - nearest_px, stroke_at_px.y));
  float coverage = clamp(stroke_extent_px.y + 0.5 - distance_px, 0.0, 1.0);
  color = vec4(stroke_color.rgb, stroke_color.a * coverage);
}
