// The camera model of CAMERA_MODEL (0 pinhole, 1 radial-tangential, 2 Kannala-Brandt 4): the formulas of
// core/geometry/camera_model.cpp in float. Needs align_types.glsl. `scale` is 2^-level.

const float kMaxTangentSquared = 1e8;  // x^2 + y^2 of a ray that counts as parallel to the image plane
const float kAxisSquared = 1e-12;      // X^2 + Y^2 below which a ray lies on the optical axis

struct Projected {
  bool ok;   // false behind the camera or beyond the largest radius
  vec2 uv;   // px of the level
  vec3 J_u;  // d u / d(camera point)
  vec3 J_v;
};

#if CAMERA_MODEL == 2

// atan(r, z) for r >= 0. The built-in may be off by 4096 ulp, a tenth of a pixel. Four half-angle steps,
// tan(x/2) = tan x / (1 + sqrt(1 + tan^2 x)), then the power series on at most pi/16.
float angleFromAxis(float r, float z) {
  float range = sqrt(r * r + z * z);
  float t = z >= 0.0 ? r / (range + z) : (range - z) / r;
  for (int i = 0; i < 3; ++i) t /= 1.0 + sqrt(1.0 + t * t);
  float t2 = t * t;
  return 16.0 * t * (1.0 - t2 * (1.0 / 3.0 - t2 * (1.0 / 5.0 - t2 * (1.0 / 7.0 - t2 / 9.0))));
}

float distortedAngle(float theta) {
  float t2 = theta * theta;
  vec4 k = constants.distortion;
  return theta * (1.0 + t2 * (k.x + t2 * (k.y + t2 * (k.z + t2 * k.w))));
}

float distortedAngleSlope(float theta) {
  float t2 = theta * theta;
  vec4 k = constants.distortion;
  return 1.0 + t2 * (3.0 * k.x + t2 * (5.0 * k.y + t2 * (7.0 * k.z + t2 * 9.0 * k.w)));
}

Projected projectPoint(vec3 p_cam, float scale) {
  float r2 = dot(p_cam.xy, p_cam.xy);
  bool on_axis = r2 <= kAxisSquared;
  float r = sqrt(r2);
  float theta = on_axis ? 0.0 : angleFromAxis(r, p_cam.z);
  Projected result;
  result.ok = theta <= constants.lens.y && (!on_axis || p_cam.z > 0.0);
  float stretch = on_axis ? 1.0 / p_cam.z : distortedAngle(theta) / r;
  float slope = distortedAngleSlope(theta) / (r2 + p_cam.z * p_cam.z);
  float bend = on_axis ? 0.0 : (slope * p_cam.z - stretch) / r2;
  vec4 f = scale * constants.focal_center;
  result.uv = f.xy * stretch * p_cam.xy + f.zw;
  result.J_u = f.x * vec3(stretch + bend * p_cam.x * p_cam.x, bend * p_cam.x * p_cam.y, -slope * p_cam.x);
  result.J_v = f.y * vec3(bend * p_cam.x * p_cam.y, stretch + bend * p_cam.y * p_cam.y, -slope * p_cam.y);
  return result;
}

#else

// Distorted normalised coordinates and their derivative by xy (symmetric for this model).
void distortPoint(vec2 xy, out vec2 distorted, out vec3 slope_xx_xy_yy) {
#if CAMERA_MODEL == 1
  vec4 k = constants.distortion;
  float k3 = constants.lens.x;
  float r2 = dot(xy, xy);
  float g = 1.0 + r2 * (k.x + r2 * (k.y + r2 * k3));
  float dg = 2.0 * (k.x + r2 * (2.0 * k.y + r2 * 3.0 * k3));  // dg/dr2, twice
  distorted = xy * g + vec2(2.0 * k.z * xy.x * xy.y + k.w * (r2 + 2.0 * xy.x * xy.x),
                            k.z * (r2 + 2.0 * xy.y * xy.y) + 2.0 * k.w * xy.x * xy.y);
  slope_xx_xy_yy = vec3(g + dg * xy.x * xy.x + 2.0 * k.z * xy.y + 6.0 * k.w * xy.x,
                        dg * xy.x * xy.y + 2.0 * k.z * xy.x + 2.0 * k.w * xy.y,
                        g + dg * xy.y * xy.y + 6.0 * k.z * xy.y + 2.0 * k.w * xy.x);
#else
  distorted = xy;
  slope_xx_xy_yy = vec3(1.0, 0.0, 1.0);
#endif
}

Projected projectPoint(vec3 p_cam, float scale) {
  float inverse_z = 1.0 / p_cam.z;
  vec2 xy = p_cam.xy * inverse_z;
  float r2 = dot(xy, xy);
  Projected result;
  result.ok = p_cam.z > 0.0 && r2 <= constants.lens.y && r2 < kMaxTangentSquared;
  vec2 distorted;
  vec3 slope;
  distortPoint(xy, distorted, slope);
  vec4 f = scale * constants.focal_center;
  result.uv = f.xy * distorted + f.zw;
  result.J_u = f.x * inverse_z * vec3(slope.xy, -dot(slope.xy, xy));
  result.J_v = f.y * inverse_z * vec3(slope.yz, -dot(slope.yz, xy));
  return result;
}

#endif
