#include "geometry/p3p.h"

#include "geometry/polynomial.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glide {
namespace {

/// Sine of the angle at a world point below which the three are collinear.
constexpr double kCollinear = 1e-6;

/// Largest ratio of the distances to two of the points.
constexpr double kMaxRatio = 1e3;

constexpr int kNewtonSteps = 3;

/// Relative error of a squared side above which a polished solution is none.
constexpr double kMaxSideError = 1e-6;

/// c0 + c1 v + c2 v^2.
using Quadratic = std::array<double, 3>;

Quartic product(const Quadratic& a, const Quadratic& b) {
  return {a[0] * b[0],
          a[0] * b[1] + a[1] * b[0],
          a[0] * b[2] + a[1] * b[1] + a[2] * b[0],
          a[1] * b[2] + a[2] * b[1],
          a[2] * b[2]};
}

/// Squared sides and cosines of the angles between bearings; entry i lies opposite of point i.
struct Triangle {
  Vec3d side2;
  Vec3d cosine;
};

Triangle triangleOf(const PointBearings& points) {
  const auto& p = points.p_world;
  const auto& f = points.bearing;
  return {
      Vec3d((p[1] - p[2]).squaredNorm(), (p[0] - p[2]).squaredNorm(), (p[0] - p[1]).squaredNorm()),
      Vec3d(f[1].dot(f[2]), f[0].dot(f[2]), f[0].dot(f[1]))};
}

/// Squared sides that the distances s give, less the true ones, relative to the longest.
Vec3d sideErrors(const Triangle& triangle, const Vec3d& s) {
  const Vec3d& c = triangle.cosine;
  const Vec3d sides2(s(1) * s(1) + s(2) * s(2) - 2.0 * s(1) * s(2) * c(0),
                     s(0) * s(0) + s(2) * s(2) - 2.0 * s(0) * s(2) * c(1),
                     s(0) * s(0) + s(1) * s(1) - 2.0 * s(0) * s(1) * c(2));
  return (sides2 - triangle.side2) / triangle.side2.maxCoeff();
}

std::optional<Vec3d> polished(const Triangle& triangle, Vec3d s) {
  const Vec3d& c = triangle.cosine;
  for (int i = 0; i < kNewtonSteps; ++i) {
    Mat3d J;
    J << 0.0, s(1) - s(2) * c(0), s(2) - s(1) * c(0),  //
        s(0) - s(2) * c(1), 0.0, s(2) - s(0) * c(1),   //
        s(0) - s(1) * c(2), s(1) - s(0) * c(2), 0.0;
    J *= 2.0 / triangle.side2.maxCoeff();
    const Vec3d step = J.partialPivLu().solve(sideErrors(triangle, s));
    if (!step.allFinite()) break;
    s -= step;
  }
  const bool solved = sideErrors(triangle, s).cwiseAbs().maxCoeff() < kMaxSideError;
  return solved && s.minCoeff() > 0.0 ? std::optional(s) : std::nullopt;
}

/// Distances to the three points. With s2 = u s1 and s3 = v s1 the sides give u = N(v) / D(v), and
/// then a quartic in v.
std::vector<Vec3d> solveDistances(const Triangle& triangle) {
  const double cos_a = triangle.cosine(0);
  const double cos_b = triangle.cosine(1);
  const double cos_c = triangle.cosine(2);
  const double a2 = triangle.side2(0) / triangle.side2(1);
  const double c2 = triangle.side2(2) / triangle.side2(1);
  const double k = a2 - c2;
  const Quadratic N{-1.0 - k, 2.0 * k * cos_b, 1.0 - k};
  const Quadratic D{-2.0 * cos_c, 2.0 * cos_a, 0.0};
  const Quadratic rest{1.0 - c2, 2.0 * c2 * cos_b, -c2};  // 1 - c2 (1 - 2 cos_b v + v^2)
  const Quartic NN = product(N, N);
  const Quartic ND = product(N, D);
  const Quartic DD = product(D, D);
  const Quartic rest_DD = product(rest, {DD[0], DD[1], DD[2]});  // D is linear
  Quartic quartic{};
  for (std::size_t i = 0; i < quartic.size(); ++i) {
    quartic[i] = NN[i] - 2.0 * cos_c * ND[i] + rest_DD[i];
  }

  std::vector<Vec3d> distances;
  for (const double v : rootsBetween(quartic, 1.0 / kMaxRatio, kMaxRatio)) {
    const double u = (N[0] + v * (N[1] + v * N[2])) / (D[0] + v * D[1]);
    const double s1 = std::sqrt(triangle.side2(1) / (1.0 + v * (v - 2.0 * cos_b)));
    if (!(u > 0.0 && std::isfinite(u * s1))) continue;
    const std::optional<Vec3d> s = polished(triangle, s1 * Vec3d(1.0, u, v));
    if (s) distances.push_back(*s);
  }
  return distances;
}

/// Orthonormal axes that three points fix.
Mat3d axesOf(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2) {
  const Vec3d x = (p1 - p0).normalized();
  const Vec3d z = x.cross(p2 - p0).normalized();
  Mat3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

}  // namespace

std::vector<SE3d> solveP3p(const PointBearings& points) {
  const auto& p = points.p_world;
  const auto& f = points.bearing;
  const Vec3d edge_1 = p[1] - p[0];
  const Vec3d edge_2 = p[2] - p[0];
  if (!(edge_1.cross(edge_2).norm() > kCollinear * edge_1.norm() * edge_2.norm())) return {};

  std::vector<SE3d> poses;
  for (const Vec3d& s : solveDistances(triangleOf(points))) {
    const Mat3d axes_cam = axesOf(s(0) * f[0], s(1) * f[1], s(2) * f[2]);
    const Mat3d R_cam_world = axes_cam * axesOf(p[0], p[1], p[2]).transpose();
    const Eigen::Quaterniond q = Eigen::Quaterniond(R_cam_world).normalized();
    poses.push_back({q, s(0) * f[0] - q * p[0]});
  }
  return poses;
}

}  // namespace glide
