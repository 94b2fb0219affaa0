#include "geometry/essential.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace glide {

Mat3d essentialOf(const SE3d& T_b_a) { return skew(T_b_a.t) * T_b_a.rotation(); }

double sampsonSquared(const Mat3d& E, const RayPair& pair) {
  const Vec3d normal_b = E * pair.a.f;
  const Vec3d normal_a = E.transpose() * pair.b.f;
  const double algebraic = pair.b.f.dot(normal_b);
  const double slope = (pair.b.J_bearing_uv.transpose() * normal_b).squaredNorm() +
                       (pair.a.J_bearing_uv.transpose() * normal_a).squaredNorm();
  return algebraic * algebraic / slope;
}

std::array<SE3d, 4> posesOfEssential(const Mat3d& E) {
  const Eigen::JacobiSVD<Mat3d> svd(E, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3d U = svd.matrixU();
  Mat3d V = svd.matrixV();
  if (U.determinant() < 0.0) U = -U;
  if (V.determinant() < 0.0) V = -V;
  Mat3d W;
  W << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const Eigen::Quaterniond q1(Mat3d(U * W * V.transpose()));
  const Eigen::Quaterniond q2(Mat3d(U * W.transpose() * V.transpose()));
  const Vec3d t = U.col(2);
  return {SE3d{q1.normalized(), t},
          SE3d{q1.normalized(), -t},
          SE3d{q2.normalized(), t},
          SE3d{q2.normalized(), -t}};
}

}  // namespace glide
