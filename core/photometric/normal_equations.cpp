#include "photometric/normal_equations.h"

#include <cmath>

// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photometric/normal_equations.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GLIDE_PHOTOMETRIC_NORMAL_EQUATIONS_ONCE
#define GLIDE_PHOTOMETRIC_NORMAL_EQUATIONS_ONCE
namespace glide {
namespace {
struct alignas(64) PackedSums {
  PackedHessian H{};
  PackedGradient b{};
};
}  // namespace
}  // namespace glide
#endif

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void addTerms(std::span<const NormalTerm> terms, PackedSums* sums) {
  const hn::CappedTag<double, std::tuple_size<PackedGradient>::value> d;
  const std::size_t lanes = hn::Lanes(d);
  for (const NormalTerm& term : terms) {
    const PointNormal& point = *term.point;
    const auto weight = hn::Set(d, term.weight);
    for (std::size_t i = 0; i < sums->H.size(); i += lanes) {
      double* sum = sums->H.data() + i;
      hn::Store(hn::MulAdd(weight, hn::Load(d, point.H.data() + i), hn::Load(d, sum)), d, sum);
    }
    const auto along_x = hn::Set(d, term.weight * term.gx_r);
    const auto along_y = hn::Set(d, term.weight * term.gy_r);
    for (std::size_t i = 0; i < sums->b.size(); i += lanes) {
      double* sum = sums->b.data() + i;
      const auto x_part = hn::MulAdd(along_x, hn::Load(d, point.jx.data() + i), hn::Load(d, sum));
      hn::Store(hn::MulAdd(along_y, hn::Load(d, point.jy.data() + i), x_part), d, sum);
    }
  }
}

}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {

HWY_EXPORT(addTerms);

namespace {

constexpr double kDamping = 1e-6;   // of the scaled system, whose diagonal is one
constexpr double kMinPivot = 1e-9;  // below it the system says nothing about a direction

/// Lower Cholesky factor of A in its lower triangle; false when a pivot is too small.
bool factorise(Mat6d* A) {
  Mat6d& L = *A;
  for (int j = 0; j < 6; ++j) {
    const double pivot = L(j, j) - L.row(j).head(j).squaredNorm();
    if (!(pivot > kMinPivot)) return false;
    L(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 6; ++i) {
      L(i, j) = (L(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
    }
  }
  return true;
}

}  // namespace

PointNormal makePointNormal(const Mat26d& J_uv_twist, const Vec3d& gxx_gxy_gyy) {
  Mat2d G;
  G << gxx_gxy_gyy.x(), gxx_gxy_gyy.y(), gxx_gxy_gyy.y(), gxx_gxy_gyy.z();
  const Mat6d H = J_uv_twist.transpose() * G * J_uv_twist;
  PointNormal point;
  std::size_t at = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) point.H[at++] = H(i, j);
    point.jx[static_cast<std::size_t>(i)] = J_uv_twist(0, i);
    point.jy[static_cast<std::size_t>(i)] = J_uv_twist(1, i);
  }
  return point;
}

Mat6d unpackHessian(const PackedHessian& packed) {
  Mat6d H;
  std::size_t at = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) H(i, j) = H(j, i) = packed[at++];
  }
  return H;
}

NormalEquations accumulateNormals(std::span<const NormalTerm> terms) {
  PackedSums sums;
  HWY_DYNAMIC_DISPATCH(addTerms)(terms, &sums);
  NormalEquations out;
  out.H = unpackHessian(sums.H);
  out.b = Eigen::Map<const Vec6d>(sums.b.data());
  return out;
}

std::optional<Vec6d> solveNormals(const NormalEquations& normals) {
  const Vec6d diagonal = normals.H.diagonal();
  for (int i = 0; i < 6; ++i) {
    if (!(diagonal(i) > kMinPivot)) return std::nullopt;
  }
  const Vec6d scale = diagonal.cwiseSqrt().cwiseInverse();
  Mat6d A = scale.asDiagonal() * normals.H * scale.asDiagonal();
  A.diagonal().array() += kDamping;
  if (!factorise(&A)) return std::nullopt;
  Vec6d y = scale.cwiseProduct(normals.b);
  A.triangularView<Eigen::Lower>().solveInPlace(y);
  A.triangularView<Eigen::Lower>().transpose().solveInPlace(y);
  const Vec6d delta = scale.cwiseProduct(y);
  if (!delta.allFinite()) return std::nullopt;
  return delta;
}

}  // namespace glide
#endif
