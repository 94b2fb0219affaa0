#include "geometry/triangulate.h"

#include <cmath>

namespace glide {
namespace {

/// Squared sine of the angle between two corrected rays below which their crossing is noise: 1e-7
/// rad.
constexpr double kParallelSineSquared = 1e-14;

/// Unit normal n of the plane through the baseline that lies closest to both bearings: the minimum
/// of (n.a)^2 + (n.b)^2 over n perpendicular to the baseline, a 2x2 eigenproblem in closed form.
Vec3d epipolarPlaneNormal(const Vec3d& baseline, const Vec3d& a, const Vec3d& b) {
  const Vec3d e1 = baseline.unitOrthogonal();
  const Vec3d e2 = baseline.normalized().cross(e1);
  const Vec2d a_plane(e1.dot(a), e2.dot(a));
  const Vec2d b_plane(e1.dot(b), e2.dot(b));
  const double xx = a_plane.x() * a_plane.x() + b_plane.x() * b_plane.x();
  const double yy = a_plane.y() * a_plane.y() + b_plane.y() * b_plane.y();
  const double xy = a_plane.x() * a_plane.y() + b_plane.x() * b_plane.y();
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the largest eigenvector
  return -std::sin(angle) * e1 + std::cos(angle) * e2;
}

}  // namespace

std::optional<Vec3d> triangulate(const SE3d& T_b_a,
                                 const Vec3d& bearing_a,
                                 const Vec3d& bearing_b) {
  const Vec3d ray_a = T_b_a.q * bearing_a;
  const Vec3d n = epipolarPlaneNormal(T_b_a.t, ray_a, bearing_b);
  const Vec3d corrected_a = ray_a - n * n.dot(ray_a);
  const Vec3d corrected_b = bearing_b - n * n.dot(bearing_b);

  // depth_a * corrected_a + t = depth_b * corrected_b, both rays in the plane.
  const Vec3d cross = corrected_a.cross(corrected_b);
  const double cross2 = cross.squaredNorm();
  if (!(cross2 > kParallelSineSquared)) return std::nullopt;
  const double depth_a = corrected_b.cross(T_b_a.t).dot(cross) / cross2;
  const double depth_b = corrected_a.cross(T_b_a.t).dot(cross) / cross2;
  if (!(depth_a > 0.0 && depth_b > 0.0)) return std::nullopt;
  return T_b_a.q.conjugate() * (depth_a * corrected_a);
}

double parallaxAngle(const Vec3d& p, const Vec3d& center_a, const Vec3d& center_b) {
  const Vec3d to_a = center_a - p;
  const Vec3d to_b = center_b - p;
  return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

}  // namespace glide
