#include "geometry/ray_pair.h"

#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace glide {
namespace {

std::optional<Ray> makeRay(const CameraModel& camera, const Vec2d& uv) {
  const std::optional<Vec3d> bearing = camera.unproject(uv);
  if (!bearing) return std::nullopt;
  const std::optional<Projection> projection = camera.projectWithJacobian(*bearing);
  if (!projection) return std::nullopt;
  Ray ray;
  ray.f = *bearing;
  ray.J_uv_bearing = projection->J_uv_point;
  const Mat2d gram = ray.J_uv_bearing * ray.J_uv_bearing.transpose();
  ray.J_bearing_uv = ray.J_uv_bearing.transpose() * gram.inverse();
  ray.px_per_rad = std::sqrt(std::sqrt(gram.determinant()));
  return ray;
}

}  // namespace

std::vector<RayPair> makeRayPairs(const CameraModel& camera, std::span<const PixelPair> pairs) {
  std::vector<RayPair> rays;
  rays.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::optional<Ray> a = makeRay(camera, pairs[i].uv_a);
    const std::optional<Ray> b = makeRay(camera, pairs[i].uv_b);
    if (a && b) rays.push_back({*a, *b, i});
  }
  return rays;
}

}  // namespace glide
