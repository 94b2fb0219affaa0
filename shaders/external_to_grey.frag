#version 100
// Grey levels of a frame in an external texture, for devices whose ESSL 3 cannot sample one: drawn into an r8 target of
// the frame's size, first row first. Uniforms as in texture_source.glsl.
//   in   texture 0   external
#extension GL_OES_EGL_image_external : require
precision highp float;
#include "luma_weights.glsl"
uniform samplerExternalOES source;
uniform vec2 origin;
uniform vec2 per_column;
uniform vec2 per_row;
uniform vec3 weights;

void main() {
  vec2 at = floor(gl_FragCoord.xy);
  float grey = greyOf(texture2D(source, origin + at.x * per_column + at.y * per_row).rgb, weights);
  gl_FragColor = vec4(grey / 255.0);
}
