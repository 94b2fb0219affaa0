#version 310 es
// The ground of the map from above: a plain colour with a thin frame.
precision highp float;

layout(location = 0) uniform vec4 panel_color;
layout(location = 1) uniform vec4 area;  // of the viewport: left, bottom, right, top: px
layout(location = 0) out vec4 color;

const float kFramePx = 1.0;
const vec4 kFrameColor = vec4(0.5, 0.5, 0.5, 0.7);

void main() {
  vec2 from_low = gl_FragCoord.xy - area.xy;
  vec2 from_high = area.zw - gl_FragCoord.xy;
  vec2 from_edge = min(from_low, from_high);
  color = min(from_edge.x, from_edge.y) < kFramePx ? kFrameColor : panel_color;
}
