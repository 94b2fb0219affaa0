#include "geometry/align_sim3.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cassert>
#include <cstddef>

namespace glide {
namespace {

/// Points are collinear when the second singular value of their covariance is below this share of
/// the first: a spread of 1e-6 of the length, far above rounding.
constexpr double kCollinearRatio = 1e-12;

Vec3d meanOf(std::span<const Vec3d> points) {
  Vec3d sum = Vec3d::Zero();
  for (const Vec3d& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::optional<Sim3d> alignSim3(std::span<const Vec3d> points_a,
                               std::span<const Vec3d> points_b,
                               AlignScale scale) {
  assert(points_a.size() == points_b.size());
  if (points_a.size() < 3) return std::nullopt;
  const Vec3d mean_a = meanOf(points_a);
  const Vec3d mean_b = meanOf(points_b);

  // Sums in place of the paper's means: the factor 1/n cancels in rotation and scale.
  Mat3d covariance = Mat3d::Zero();
  double variance_b = 0.0;
  for (std::size_t i = 0; i < points_a.size(); ++i) {
    covariance += (points_a[i] - mean_a) * (points_b[i] - mean_b).transpose();
    variance_b += (points_b[i] - mean_b).squaredNorm();
  }

  const Eigen::JacobiSVD<Mat3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3d singular = svd.singularValues();
  if (!(singular(1) > kCollinearRatio * singular(0))) return std::nullopt;

  // Umeyama eq. 39-43: the last axis is flipped where the best orthogonal matrix is a reflection.
  const double det = svd.matrixU().determinant() * svd.matrixV().determinant();
  const Vec3d signs(1.0, 1.0, det < 0.0 ? -1.0 : 1.0);
  const Mat3d R_a_b = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  Sim3d S_a_b;
  S_a_b.q = Eigen::Quaterniond(R_a_b).normalized();
  S_a_b.s = scale == AlignScale::fixed ? 1.0 : singular.dot(signs) / variance_b;
  S_a_b.t = mean_a - S_a_b.s * (S_a_b.q * mean_b);
  return S_a_b;
}

}  // namespace glide
