#version 100
// render_camera_picture.frag for external textures, whether or not ESSL 3 can sample them.
//   in   texture 0   external
#extension GL_OES_EGL_image_external : require
precision highp float;
uniform samplerExternalOES source;
uniform vec2 upper_left;
uniform vec2 origin;
uniform vec2 per_x;
uniform vec2 per_y;
uniform float tap;
uniform float grey;

vec3 sampleAt(vec2 at) { return texture2D(source, origin + at.x * per_x + at.y * per_y).rgb; }

void main() {
  vec2 at = vec2(gl_FragCoord.x - upper_left.x, upper_left.y - gl_FragCoord.y);
  vec3 sum = sampleAt(at + vec2(-tap, -tap)) + sampleAt(at + vec2(tap, -tap)) + sampleAt(at + vec2(-tap, tap)) +
             sampleAt(at + vec2(tap, tap));
  vec3 color = 0.25 * sum;
  gl_FragColor = vec4(mix(color, color.rrr, grey), 1.0);
}
