#version 310 es
// Landmarks: one vertex each. Size and alpha by observations and by distance.
precision highp float;

#include "render_map_view.glsl"
layout(location = 3) uniform float largest_px;  // diameter of a landmark with many observations
layout(location = 4) uniform float count;       // coloured by age: of all landmarks; 0: by height
layout(location = 5) uniform float heights[5];  // coloured by height: of each colour, ascending

layout(location = 0) in vec4 landmark;  // position in the world, observations
flat out vec4 point_color;
flat out float point_px;  // diameter

const float kFew = 2.0;    // observations of a new landmark
const float kMany = 12.0;  // from here on a landmark is certain

const vec3 kOld = vec3(0.55, 0.56, 0.58);
const vec3 kNew = vec3(0.05, 0.62, 0.30);
// From low to high; readable on white and on black.
const int kSteps = 4;
const float kLeastSpan = 1e-6;  // of heights that are all alike
const vec3 kHeightColors[kSteps + 1] = vec3[](vec3(0.24, 0.42, 0.88),
                                              vec3(0.09, 0.63, 0.74),
                                              vec3(0.33, 0.70, 0.30),
                                              vec3(0.92, 0.64, 0.13),
                                              vec3(0.84, 0.22, 0.16));

vec3 colorOfHeight(float height) {
  vec3 color = kHeightColors[0];
  for (int i = 0; i < kSteps; ++i) {
    float span = max(heights[i + 1] - heights[i], kLeastSpan);
    color = mix(color, kHeightColors[i + 1], clamp((height - heights[i]) / span, 0.0, 1.0));
  }
  return color;
}

void main() {
  vec3 p_eye = toEye(landmark.xyz);
  gl_Position = clip_from_eye * vec4(p_eye, 1.0);
  float certainty = clamp((landmark.w - kFew) / (kMany - kFew), 0.0, 1.0);
  float near = nearness(p_eye);
  point_px = largest_px * mix(0.65, 1.0, certainty) * mix(0.75, 1.2, near);
  gl_PointSize = point_px + 1.0;  // and the soft edge
  vec3 color = count > 0.0 ? mix(kOld, kNew, float(gl_VertexID) / count)
                           : colorOfHeight(-landmark.y);  // the world's y axis points down
  point_color = vec4(color, mix(0.55, 1.0, certainty) * mix(0.55, 1.0, near));
}
