#version 310 es
// Cameras: one instance each. The first six vertices are the image plane (two triangles), then come
// eight edges of six vertices (two triangles of a stroke).
precision highp float;

#include "render_map_view.glsl"
#include "render_map_stroke.glsl"
layout(location = 5) uniform vec4 image_plane;  // left, top, right, bottom, at distance 1
layout(location = 6) uniform vec3 look;         // distance of the image plane; alpha of it and of the edges

layout(location = 0) in vec3 position_world;
layout(location = 1) in vec4 q_world_cam;  // x, y, z, w
layout(location = 2) in vec4 camera_color;

const int kPlaneVertices = 6;
const int kPlaneCorner[6] = int[](0, 1, 2, 0, 2, 3);
const int kStripCorner[6] = int[](0, 1, 2, 2, 1, 3);  // of a strip's four, as two triangles

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// Corner 0..3 of the image plane, clockwise from the upper left.
vec3 planeCorner(int corner) {
  float x = corner == 0 || corner == 3 ? image_plane.x : image_plane.z;
  float y = corner < 2 ? image_plane.y : image_plane.w;
  return position_world + rotate(q_world_cam, look.x * vec3(x, y, 1.0));
}

vec4 toClip(vec3 p_world) { return clip_from_eye * vec4(toEye(p_world), 1.0); }

void main() {
  if (gl_VertexID < kPlaneVertices) {
    stroke_at_px = vec2(0.0);
    stroke_extent_px = vec2(0.0, 0.5);
    stroke_color = vec4(camera_color.rgb, look.y);
    gl_Position = toClip(planeCorner(kPlaneCorner[gl_VertexID]));
    return;
  }
  int edge = (gl_VertexID - kPlaneVertices) / 6;
  int corner = edge % 4;
  bool is_to_apex = edge < 4;
  vec3 begin = is_to_apex ? position_world : planeCorner((corner + 1) % 4);
  drawStroke(toClip(begin),
             toClip(planeCorner(corner)),
             kStripCorner[(gl_VertexID - kPlaneVertices) % 6],
             vec4(camera_color.rgb, look.z));
}
