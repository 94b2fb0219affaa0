// Rigid transforms in float: unit quaternion (x y z w) and translation.

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// Hamilton product.
vec4 multiplyQuaternions(vec4 a, vec4 b) {
  return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

// exp of a twist (translation v, rotation w): quaternion and translation. By power series: the built-in
// sin and cos may be off by 5e-4, and steps of the aligner are small. Float precision up to pi; steps
// beyond mean a lost track, and get a valid rotation of some other angle.
void expTwist(vec3 v, vec3 w, out vec4 q, out vec3 t) {
  const float kLargestSquared = 9.8696044;  // pi^2
  float a2 = min(dot(w, w), kLargestSquared);
  float h2 = 0.25 * a2;
  // sin(a/2)/a, cos(a/2) and (a - sin a)/a^3
  float half_sinc = 0.5 * (1.0 - h2 / 6.0 * (1.0 - h2 / 20.0 * (1.0 - h2 / 42.0 * (1.0 - h2 / 72.0 *
                    (1.0 - h2 / 110.0 * (1.0 - h2 / 156.0))))));
  float half_cos = 1.0 - h2 / 2.0 * (1.0 - h2 / 12.0 * (1.0 - h2 / 30.0 * (1.0 - h2 / 56.0 *
                   (1.0 - h2 / 90.0 * (1.0 - h2 / 132.0)))));
  float c = (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0 * (1.0 - a2 / 110.0 *
            (1.0 - a2 / 156.0 * (1.0 - a2 / 210.0 * (1.0 - a2 / 272.0))))))) / 6.0;
  float b = 2.0 * half_sinc * half_sinc;  // (1 - cos a)/a^2
  q = vec4(half_sinc * w, half_cos);
  vec3 wv = cross(w, v);
  t = v + b * wv + c * cross(w, wv);
}
