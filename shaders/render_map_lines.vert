#version 310 es
// Lines between points of the world: one instance each, four vertices (a strip).
precision highp float;

#include "render_map_view.glsl"
#include "render_map_stroke.glsl"

layout(location = 0) in vec3 begin_world;
layout(location = 1) in vec3 end_world;
layout(location = 2) in vec4 end_color;  // alpha 0: no line

void main() {
  vec3 begin_eye = toEye(begin_world);
  vec3 end_eye = toEye(end_world);
  float fade = mix(0.7, 1.0, nearness(0.5 * (begin_eye + end_eye)));
  drawStroke(clip_from_eye * vec4(begin_eye, 1.0),
             clip_from_eye * vec4(end_eye, 1.0),
             gl_VertexID,
             vec4(end_color.rgb, end_color.a * fade));
}
