#include "geometry/rotation_only.h"

#include "geometry/lie.h"

#include <Eigen/Cholesky>

#include <array>
#include <cmath>
#include <cstddef>

namespace glide {
namespace {

/// Tukey's constant: 95 % efficiency on Gaussian noise.
constexpr double kTukey = 4.685;

/// Scale of the weight, in sigmas, iteration by iteration: wide first, for a coarse start.
constexpr std::array<double, 10> kScales{16.0, 8.0, 4.0, 2.0, 1.5, 1.0, 1.0, 1.0, 1.0, 1.0};

/// Keeps the solve defined when no pair is left, px^2 per rad^2 (a pixel is far below a radian).
constexpr double kDamping = 1e-3;

}  // namespace

Vec2d rotationError(const Eigen::Quaterniond& R_b_a, const RayPair& pair) {
  const Vec3d mapped = R_b_a * pair.a.f;
  return pair.b.J_uv_bearing * mapped / pair.b.f.dot(mapped);
}

Eigen::Quaterniond fitRotation(const Eigen::Quaterniond& start,
                               std::span<const RayPair> pairs,
                               double sigma_px) {
  Eigen::Quaterniond R_b_a = start;
  for (const double scale : kScales) {
    // Both pixels of a pair carry noise: the difference has twice the variance.
    const double cutoff2 = 2.0 * std::pow(kTukey * sigma_px * scale, 2.0);
    Mat3d H = kDamping * Mat3d::Identity();
    Vec3d b = Vec3d::Zero();
    for (const RayPair& pair : pairs) {
      const Vec3d mapped = R_b_a * pair.a.f;
      const Vec2d error = rotationError(R_b_a, pair);
      const double ratio2 = error.squaredNorm() / cutoff2;
      if (!(ratio2 < 1.0) || pair.b.f.dot(mapped) <= 0.0) continue;
      const double weight = (1.0 - ratio2) * (1.0 - ratio2);
      const Mat23d J_error_rotation = -pair.b.J_uv_bearing * skew(mapped);
      H.noalias() += weight * J_error_rotation.transpose() * J_error_rotation;
      b.noalias() -= weight * J_error_rotation.transpose() * error;
    }
    R_b_a = (so3Exp(H.ldlt().solve(b)) * R_b_a).normalized();
  }
  return R_b_a;
}

}  // namespace glide
