#include "geometry/lie.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace glide {
namespace {

/// Below this squared angle the closed forms lose digits and a Taylor series has none to lose: its
/// first dropped term is under 1e-17.
constexpr double kSmallAngleSquared = 1e-4;

/// V of exp(v, w) = (exp(w), V v): I + (1 - cos)/theta^2 [w] + (theta - sin)/theta^3 [w]^2.
Mat3d leftJacobian(const Vec3d& omega) {
  const double theta2 = omega.squaredNorm();
  double first = 0.5 - theta2 / 24.0 + theta2 * theta2 / 720.0;
  double second = 1.0 / 6.0 - theta2 / 120.0 + theta2 * theta2 / 5040.0;
  if (theta2 > kSmallAngleSquared) {
    const double theta = std::sqrt(theta2);
    const double half_sine = std::sin(0.5 * theta);
    first = 2.0 * half_sine * half_sine / theta2;
    second = (theta - std::sin(theta)) / (theta2 * theta);
  }
  const Mat3d W = skew(omega);
  return Mat3d::Identity() + first * W + second * W * W;
}

/// Its inverse: I - [w]/2 + (1 - theta/2 cot(theta/2))/theta^2 [w]^2, regular up to theta = pi.
Mat3d leftJacobianInverse(const Vec3d& omega) {
  const double theta2 = omega.squaredNorm();
  double second = 1.0 / 12.0 + theta2 / 720.0 + theta2 * theta2 / 30240.0;
  if (theta2 > kSmallAngleSquared) {
    const double half = 0.5 * std::sqrt(theta2);
    second = (1.0 - half * std::cos(half) / std::sin(half)) / theta2;
  }
  const Mat3d W = skew(omega);
  return Mat3d::Identity() - 0.5 * W + second * W * W;
}

/// W of Sim(3)'s exp(v, w, l) = (exp(l), exp(w), W v): the integral of exp(l x) exp(x [w]) over x
/// in 0..1. Ten Gauss-Legendre nodes reach rounding error for rotations up to pi and scales of
/// 1e-2..1e2 and need none of the special cases of the closed form.
Mat3d similarityJacobian(const Vec3d& omega, double log_scale) {
  struct Node {
    double offset, weight;  // on -1..1, symmetric
  };
  static constexpr std::array<Node, 5> kNodes{{{0.1488743389816312, 0.2955242247147529},
                                               {0.4333953941292472, 0.2692667193099963},
                                               {0.6794095682990244, 0.2190863625159820},
                                               {0.8650633666889845, 0.1494513491505806},
                                               {0.9739065285171717, 0.0666713443086881}}};
  Mat3d integral = Mat3d::Zero();
  const auto add = [&](double x, double weight) {
    integral += 0.5 * weight * std::exp(log_scale * x) * so3Exp(x * omega).toRotationMatrix();
  };
  for (const Node& node : kNodes) {
    add(0.5 - 0.5 * node.offset, node.weight);
    add(0.5 + 0.5 * node.offset, node.weight);
  }
  return integral;
}

}  // namespace

Mat3d skew(const Vec3d& a) {
  Mat3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Eigen::Quaterniond so3Exp(const Vec3d& omega) {
  const double theta2 = omega.squaredNorm();
  double real = 1.0 - theta2 / 8.0 + theta2 * theta2 / 384.0;
  double imaginary = 0.5 - theta2 / 48.0 + theta2 * theta2 / 3840.0;
  if (theta2 > kSmallAngleSquared) {
    const double theta = std::sqrt(theta2);
    real = std::cos(0.5 * theta);
    imaginary = std::sin(0.5 * theta) / theta;
  }
  const Vec3d vec = imaginary * omega;
  return Eigen::Quaterniond(real, vec.x(), vec.y(), vec.z());
}

Vec3d so3Log(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;  // q and -q are one rotation: take the short way
  const double real = sign * q.w();
  const Vec3d vec = sign * q.vec();
  const double sine2 = vec.squaredNorm();
  if (sine2 < kSmallAngleSquared * 0.25) {
    const double ratio2 = sine2 / (real * real);
    return (2.0 / real) * (1.0 - ratio2 / 3.0 + ratio2 * ratio2 / 5.0) * vec;
  }
  const double sine = std::sqrt(sine2);
  return (2.0 * std::atan2(sine, real) / sine) * vec;
}

SE3d SE3d::exp(const Vec6d& twist) {
  const Vec3d omega = twist.tail<3>();
  return SE3d{so3Exp(omega), leftJacobian(omega) * twist.head<3>()};
}

Vec6d SE3d::log() const {
  const Vec3d omega = so3Log(q);
  Vec6d twist;
  twist << leftJacobianInverse(omega) * t, omega;
  return twist;
}

SE3d SE3d::inverse() const {
  const Eigen::Quaterniond q_inverse = q.conjugate();
  return SE3d{q_inverse, -(q_inverse * t)};
}

Mat4d SE3d::matrix() const {
  Mat4d m = Mat4d::Identity();
  m.topLeftCorner<3, 3>() = rotation();
  m.topRightCorner<3, 1>() = t;
  return m;
}

Mat6d SE3d::adjoint() const {
  const Mat3d R = rotation();
  Mat6d m;
  m << R, skew(t) * R, Mat3d::Zero(), R;
  return m;
}

SE3d operator*(const SE3d& T_a_b, const SE3d& T_b_c) {
  return SE3d{(T_a_b.q * T_b_c.q).normalized(), T_a_b.q * T_b_c.t + T_a_b.t};
}

Sim3d Sim3d::exp(const Vec7d& tangent) {
  const Vec3d omega = tangent.segment<3>(3);
  const double log_scale = tangent(6);
  return Sim3d{
      so3Exp(omega), similarityJacobian(omega, log_scale) * tangent.head<3>(), std::exp(log_scale)};
}

Vec7d Sim3d::log() const {
  const Vec3d omega = so3Log(q);
  const double log_scale = std::log(s);
  Vec7d tangent;
  tangent << similarityJacobian(omega, log_scale).inverse() * t, omega, log_scale;
  return tangent;
}

Sim3d Sim3d::inverse() const {
  const Eigen::Quaterniond q_inverse = q.conjugate();
  return Sim3d{q_inverse, -(q_inverse * t) / s, 1.0 / s};
}

Sim3d operator*(const Sim3d& S_a_b, const Sim3d& S_b_c) {
  return Sim3d{
      (S_a_b.q * S_b_c.q).normalized(), S_a_b.s * (S_a_b.q * S_b_c.t) + S_a_b.t, S_a_b.s * S_b_c.s};
}

Vec3d operator*(const Sim3d& S_a_b, const Vec3d& p_b) {
  return S_a_b.s * (S_a_b.q * p_b) + S_a_b.t;
}

}  // namespace glide
