#include "geometry/homography.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace glide {
namespace {

using Mat9d = Eigen::Matrix<double, 9, 9>;
using Vec9d = Eigen::Matrix<double, 9, 1>;

/// Second smallest eigenvalue of the normal matrix, relative to the largest, below which more than
/// one homography fits.
constexpr double kDegenerate = 1e-13;

/// Squared singular values this close to each other leave no translation to find.
constexpr double kNoTranslation = 1e-7;

/// Squared length of the pixel error of mapping ray `from` onto ray `to`.
double oneWaySquared(const Mat3d& H, const Ray& from, const Ray& to) {
  const Vec3d mapped = H * from.f;
  const double along = to.f.dot(mapped);
  if (!(along > 0.0)) return std::numeric_limits<double>::infinity();
  return (to.J_uv_bearing * mapped).squaredNorm() / (along * along);
}

}  // namespace

std::optional<Mat3d> fitHomography(std::span<const RayPair* const> pairs,
                                   std::span<const double> weights) {
  assert(pairs.size() == weights.size() && pairs.size() >= 4);
  // J_b (H f_a) = 0: two equations a pair, with the pixels' own scale.
  Mat9d normal = Mat9d::Zero();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Eigen::Matrix<double, 2, 9> rows;
    for (int r = 0; r < 3; ++r) {
      rows.middleCols<3>(3 * r) = pairs[i]->b.J_uv_bearing.col(r) * pairs[i]->a.f.transpose();
    }
    normal.noalias() += weights[i] * rows.transpose() * rows;
  }
  const Eigen::SelfAdjointEigenSolver<Mat9d> solver(normal);
  const Vec9d values = solver.eigenvalues();
  if (!(values(1) > kDegenerate * values(8))) return std::nullopt;
  const Vec9d h = solver.eigenvectors().col(0);
  Mat3d H = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(h.data());
  if (H.determinant() < 0.0) H = -H;
  return H;
}

double transferSquared(const Mat3d& H, const Mat3d& H_inverse, const RayPair& pair) {
  return 0.25 * (oneWaySquared(H, pair.a, pair.b) + oneWaySquared(H_inverse, pair.b, pair.a));
}

std::vector<SE3d> posesOfHomography(const Mat3d& H) {
  // Squared singular values, rising, and right singular vectors; the middle one is the plane's
  // scale.
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(H.transpose() * H);
  const double scale2 = solver.eigenvalues()(1);
  const double smallest2 = solver.eigenvalues()(0) / scale2;
  const double largest2 = solver.eigenvalues()(2) / scale2;
  if (!(largest2 - smallest2 > kNoTranslation)) return {};
  const Mat3d H_metric = H / std::sqrt(scale2);
  const Mat3d V = solver.eigenvectors();
  const double length = std::sqrt(largest2 - smallest2);
  const double along_largest = std::sqrt(std::max(0.0, 1.0 - smallest2)) / length;
  const double along_smallest = std::sqrt(std::max(0.0, largest2 - 1.0)) / length;

  std::vector<SE3d> poses;
  for (const double sign : {1.0, -1.0}) {
    // u and v2 span a plane whose vectors H turns without stretching: they give the rotation.
    const Vec3d u = along_largest * V.col(2) + sign * along_smallest * V.col(0);
    const Vec3d n = V.col(1).cross(u);
    const Vec3d mapped_v = H_metric * V.col(1);
    const Vec3d mapped_u = H_metric * u;
    Mat3d from;
    from << V.col(1), u, n;
    Mat3d to;
    to << mapped_v, mapped_u, mapped_v.cross(mapped_u);
    const Mat3d R_b_a = to * from.transpose();
    const Vec3d t = (H_metric - R_b_a) * n;
    poses.push_back({Eigen::Quaterniond(R_b_a).normalized(), t.normalized()});
  }
  return poses;
}

}  // namespace glide
