// A line between two points as a quad of the screen: OpenGL ES need not draw lines wider than a pixel.
// Shared by the vertex shaders that draw lines; render_map_stroke.frag gives them soft edges.
layout(location = 3) uniform vec2 viewport_px;
layout(location = 4) uniform vec2 stroke;  // width of the line; how far it reaches beyond its ends: px

out vec2 stroke_at_px;              // along the line from its first end, across
flat out vec2 stroke_extent_px;     // length, half of the width
flat out vec4 stroke_color;

// The part of the line from a to b that is in front of the near plane; false when nothing is.
bool clipNear(inout vec4 a, inout vec4 b) {
  float in_front_a = a.z + a.w;
  float in_front_b = b.z + b.w;
  if (in_front_a <= 0.0 && in_front_b <= 0.0) return false;
  vec4 begin = a;
  if (in_front_a < 0.0) a = mix(begin, b, in_front_a / (in_front_a - in_front_b));
  if (in_front_b < 0.0) b = mix(begin, b, in_front_a / (in_front_a - in_front_b));
  return true;
}

// Emits corner 0..3 of the strip. Positions are divided by w here, so that what is interpolated is
// linear on the screen.
void drawStroke(vec4 a_clip, vec4 b_clip, int corner, vec4 color) {
  stroke_color = color;
  stroke_at_px = vec2(0.0);
  stroke_extent_px = vec2(0.0);
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // beyond the far plane: nothing
  if (color.a == 0.0 || !clipNear(a_clip, b_clip)) return;
  vec3 a = a_clip.xyz / a_clip.w;
  vec3 b = b_clip.xyz / b_clip.w;
  vec2 along_px = 0.5 * viewport_px * (b.xy - a.xy);
  float length_px = length(along_px);
  vec2 direction = length_px > 0.0 ? along_px / length_px : vec2(1.0, 0.0);
  float half_width_px = 0.5 * max(stroke.x, 1.0);  // thinner lines are fainter ones
  stroke_color.a *= min(stroke.x, 1.0);
  stroke_extent_px = vec2(length_px, half_width_px);

  bool is_at_b = corner > 1;
  float side = (corner & 1) == 0 ? 1.0 : -1.0;
  float beyond_px = is_at_b ? stroke.y : -stroke.y;
  stroke_at_px = vec2((is_at_b ? length_px : 0.0) + beyond_px, side * (half_width_px + 0.5));
  vec2 offset_px = beyond_px * direction + stroke_at_px.y * vec2(-direction.y, direction.x);
  vec3 end = is_at_b ? b : a;
  gl_Position = vec4(end.xy + 2.0 * offset_px / viewport_px, end.z, 1.0);
}
