// From where the map is seen. Shared by all vertex shaders of the map.
layout(location = 0) uniform mat4 eye_from_world;
layout(location = 1) uniform mat4 clip_from_eye;
layout(location = 2) uniform vec2 cue;  // distance at which the scene begins, 1 / its extent from there on

vec3 toEye(vec3 p_world) { return (eye_from_world * vec4(p_world, 1.0)).xyz; }

// Depth cue: 1 where the scene begins, 0 where it ends.
float nearness(vec3 p_eye) { return clamp(1.0 - (-p_eye.z - cue.x) * cue.y, 0.0, 1.0); }
