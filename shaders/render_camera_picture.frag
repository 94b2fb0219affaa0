#version 310 es
// The camera's picture in a rectangle of the framebuffer (render/camera_picture.h).
//   in   texture 0   what can be sampled as floats
precision highp float;
uniform highp sampler2D source;
uniform vec2 upper_left;  // corner of the rectangle in the framebuffer, px
uniform vec2 origin;      // texture coordinates of that corner
uniform vec2 per_x;       // and how they change with a pixel to the right
uniform vec2 per_y;       // and with one down
uniform float tap;        // how far four samples lie from the pixel's centre, px; 0: all in it
uniform float grey;       // 1: red is grey
layout(location = 0) out vec4 fragment;

vec3 sampleAt(vec2 at) { return textureLod(source, origin + at.x * per_x + at.y * per_y, 0.0).rgb; }

void main() {
  vec2 at = vec2(gl_FragCoord.x - upper_left.x, upper_left.y - gl_FragCoord.y);
  vec3 sum = sampleAt(at + vec2(-tap, -tap)) + sampleAt(at + vec2(tap, -tap)) + sampleAt(at + vec2(-tap, tap)) +
             sampleAt(at + vec2(tap, tap));
  vec3 color = 0.25 * sum;
  fragment = vec4(mix(color, color.rrr, grey), 1.0);
}
