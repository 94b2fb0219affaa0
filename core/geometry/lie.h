#pragma once

#include "geometry/eigen_types.h"

namespace glide {

/// Skew-symmetric matrix: skew(a) * b = a x b.
Mat3d skew(const Vec3d& a);

/// Rotation vector (radians) to unit quaternion and back; log returns the shortest one.
Eigen::Quaterniond so3Exp(const Vec3d& omega);
Vec3d so3Log(const Eigen::Quaterniond& q);

/// Rigid transform. Named T_a_b: maps points of frame b into frame a.
/// Twists are (translation, rotation). Unless a function says otherwise perturbations act on the
/// left, T <- exp(delta) * T; the photometric aligner's inverse-compositional update acts on the
/// right.
struct SE3d {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  ///< unit
  Vec3d t = Vec3d::Zero();

  static SE3d exp(const Vec6d& twist);
  Vec6d log() const;
  SE3d inverse() const;
  Mat4d matrix() const;
  Mat3d rotation() const { return q.toRotationMatrix(); }
  /// Adjoint: T * exp(x) = exp(adjoint() * x) * T.
  Mat6d adjoint() const;
};

/// Compositions keep the quaternion normalised.
SE3d operator*(const SE3d& T_a_b, const SE3d& T_b_c);
inline Vec3d operator*(const SE3d& T_a_b, const Vec3d& p_b) { return T_a_b.q * p_b + T_a_b.t; }

/// Similarity transform p_a = s * R * p_b + t. Tangent is (translation, rotation, log scale).
struct Sim3d {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  ///< unit
  Vec3d t = Vec3d::Zero();
  double s = 1.0;

  static Sim3d exp(const Vec7d& tangent);
  Vec7d log() const;
  Sim3d inverse() const;
};

Sim3d operator*(const Sim3d& S_a_b, const Sim3d& S_b_c);
Vec3d operator*(const Sim3d& S_a_b, const Vec3d& p_b);

}  // namespace glide
