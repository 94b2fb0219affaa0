#include "geometry/lie.h"

#include "unit/geometry/random_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace glide {
namespace {

constexpr double kPi = 3.14159265358979323846;

Mat4d twistMatrix(const Vec6d& twist) {
  Mat4d m = Mat4d::Zero();
  m.topLeftCorner<3, 3>() = skew(twist.tail<3>());
  m.topRightCorner<3, 1>() = twist.head<3>();
  return m;
}

/// Matrix exponential by scaling and squaring of the plain series: the definition.
Mat4d matrixExponential(const Mat4d& m) {
  constexpr int kHalvings = 6;
  constexpr int kTerms = 16;
  const Mat4d small = m / std::ldexp(1.0, kHalvings);
  Mat4d power = Mat4d::Identity();
  Mat4d sum = Mat4d::Identity();
  for (int i = 1; i < kTerms; ++i) {
    power = power * small / i;
    sum += power;
  }
  for (int i = 0; i < kHalvings; ++i) sum = (sum * sum).eval();
  return sum;
}

Mat4d matrixOf(const Sim3d& S) {
  Mat4d m = Mat4d::Identity();
  m.topLeftCorner<3, 3>() = S.s * S.q.toRotationMatrix();
  m.topRightCorner<3, 1>() = S.t;
  return m;
}

TEST(Lie, SkewIsTheCrossProduct) {
  const Vec3d a(1.0, -2.0, 3.0);
  const Vec3d b(0.5, 4.0, -1.0);
  EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
}

TEST(Lie, RotationLogUndoesExpFromTinyAnglesToNearPi) {
  test::RandomGeometry random(1);
  for (const double angle :
       {0.0, 1e-300, 1e-12, 1e-8, 1e-5, 9.9e-3, 1.1e-2, 0.5, 2.0, 3.1, kPi - 1e-6, kPi - 1e-9}) {
    const Vec3d omega = angle * random.direction();
    const Vec3d back = so3Log(so3Exp(omega));
    EXPECT_LE((back - omega).norm(), 1e-14 * std::max(1.0, angle) * std::max(angle, 1e-290))
        << angle;
  }
}

TEST(Lie, RotationLogTakesTheShortWay) {
  const Eigen::Quaterniond q = so3Exp(Vec3d(0.0, 0.0, 0.3));
  const Eigen::Quaterniond minus_q(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_NEAR(so3Log(minus_q).z(), 0.3, 1e-15);
  EXPECT_NEAR(so3Log(so3Exp(Vec3d(0.0, 0.0, 1.5 * kPi))).z(), -0.5 * kPi, 1e-14);
}

TEST(Lie, Se3ExpIsTheMatrixExponential) {
  test::RandomGeometry random(2);
  for (const double angle : {0.0, 1e-9, 1e-3, 9.9e-3, 1.01e-2, 1.0, 3.0}) {
    Vec6d twist;
    twist << random.vector(2.0), angle * random.direction();
    EXPECT_LT((SE3d::exp(twist).matrix() - matrixExponential(twistMatrix(twist))).norm(), 1e-13)
        << angle;
  }
}

TEST(Lie, Se3LogUndoesExpFromTinyAnglesToNearPi) {
  test::RandomGeometry random(3);
  for (const double angle : {0.0, 1e-12, 1e-6, 9.9e-3, 1.01e-2, 0.7, 3.0, kPi - 1e-7}) {
    Vec6d twist;
    twist << random.vector(1.0), angle * random.direction();
    EXPECT_LT((SE3d::exp(twist).log() - twist).norm(), 1e-12) << angle;
  }
}

TEST(Lie, Se3ComposesAndInvertsAsItsMatrices) {
  test::RandomGeometry random(4);
  const SE3d T_a_b = random.transform(1.2, 2.0);
  const SE3d T_b_c = random.transform(2.5, 2.0);
  const Vec3d p_c = random.vector(3.0);
  EXPECT_LT(((T_a_b * T_b_c).matrix() - T_a_b.matrix() * T_b_c.matrix()).norm(), 1e-14);
  EXPECT_LT(((T_a_b * T_a_b.inverse()).matrix() - Mat4d::Identity()).norm(), 1e-14);
  EXPECT_LT(((T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c)).norm(), 1e-14);
}

TEST(Lie, LongChainsStayRotations) {
  test::RandomGeometry random(5);
  const SE3d step = random.transform(0.01, 0.1);
  SE3d chain;
  for (int i = 0; i < 100000; ++i) chain = step * chain;
  EXPECT_NEAR(chain.q.norm(), 1.0, 1e-14);
}

TEST(Lie, AdjointMovesAPerturbationFromRightToLeft) {
  test::RandomGeometry random(6);
  const SE3d T = random.transform(2.0, 1.5);
  Vec6d twist;
  twist << random.vector(0.3), random.vector(0.3);
  const SE3d right = T * SE3d::exp(twist);
  const SE3d left = SE3d::exp(T.adjoint() * twist) * T;
  EXPECT_LT((right.matrix() - left.matrix()).norm(), 1e-14);
}

TEST(Lie, Sim3ExpIsTheMatrixExponential) {
  test::RandomGeometry random(7);
  for (const double angle : {0.0, 1e-9, 1e-2, 1.0, 3.1}) {
    for (const double log_scale : {0.0, 1e-9, -1e-3, 0.7, -2.0, 4.0}) {
      Vec7d tangent;
      tangent << random.vector(1.0), angle * random.direction(), log_scale;
      Mat4d generator = twistMatrix(tangent.head<6>());
      generator.topLeftCorner<3, 3>() += log_scale * Mat3d::Identity();
      const Mat4d expected = matrixExponential(generator);
      const double error = (matrixOf(Sim3d::exp(tangent)) - expected).norm();
      EXPECT_LT(error, 1e-12 * expected.norm()) << angle << " " << log_scale;
    }
  }
}

TEST(Lie, Sim3LogUndoesExp) {
  test::RandomGeometry random(8);
  for (const double angle : {0.0, 1e-9, 1.0, kPi - 1e-6}) {
    for (const double log_scale : {0.0, 1e-10, 0.5, -3.0}) {
      Vec7d tangent;
      tangent << random.vector(1.0), angle * random.direction(), log_scale;
      EXPECT_LT((Sim3d::exp(tangent).log() - tangent).norm(), 1e-11) << angle << " " << log_scale;
    }
  }
}

TEST(Lie, Sim3ComposesAndInverts) {
  test::RandomGeometry random(9);
  const Sim3d S_a_b{so3Exp(random.vector(1.0)), random.vector(2.0), 2.5};
  const Sim3d S_b_c{so3Exp(random.vector(1.0)), random.vector(2.0), 0.3};
  const Vec3d p_c = random.vector(3.0);
  EXPECT_LT(((S_a_b * S_b_c) * p_c - S_a_b * (S_b_c * p_c)).norm(), 1e-13);
  EXPECT_LT((S_a_b.inverse() * (S_a_b * p_c) - p_c).norm(), 1e-13);
}

}  // namespace
}  // namespace glide
