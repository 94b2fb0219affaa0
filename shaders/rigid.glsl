// Rigid transforms in float: unit quaternion (x y z w) and translation.

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// Hamilton product.
vec4 multiplyQuaternions(vec4 a, vec4 b) {
  return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

// exp of a twist (translation v, rotation w): quaternion and translation.
void expTwist(vec3 v, vec3 w, out vec4 q, out vec3 t) {
  const float kSmallAngleSquared = 1e-4;  // below, three terms of the series reach float precision
  float a2 = dot(w, w);
  float a = sqrt(a2);
  bool small = a2 < kSmallAngleSquared;
  float half_sinc = small ? 0.5 - a2 / 48.0 : sin(0.5 * a) / a;
  float b = small ? 0.5 - a2 / 24.0 : (1.0 - cos(a)) / a2;
  float c = small ? 1.0 / 6.0 - a2 / 120.0 : (a - sin(a)) / (a2 * a);
  q = vec4(half_sinc * w, cos(0.5 * a));
  vec3 wv = cross(w, v);
  t = v + b * wv + c * cross(w, wv);
}
