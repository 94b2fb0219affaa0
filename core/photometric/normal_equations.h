#pragma once

#include "photometric/align_types.h"

#include <array>
#include <optional>
#include <span>

namespace glide {

/// The upper triangle of a symmetric 6x6 matrix, row by row, padded to whole vectors.
using PackedHessian = std::array<double, 24>;
/// A 6-vector, padded likewise.
using PackedGradient = std::array<double, 8>;

/// What one reference point contributes, fixed when the reference is made. The pads are zero.
struct alignas(64) PointNormal {
  PackedHessian H{};    ///< H_i
  PackedGradient jx{};  ///< Jx: derivative of u by the twist
  PackedGradient jy{};  ///< Jy
};

/// One point's part in the normal equations of an iteration.
struct NormalTerm {
  const PointNormal* point = nullptr;
  double weight = 0.0;
  double gx_r = 0.0;  ///< sum gx r
  double gy_r = 0.0;  ///< sum gy r
};

/// H = sum w H_i and b = sum w (Jx sum gx r + Jy sum gy r).
struct NormalEquations {
  Mat6d H = Mat6d::Zero();
  Vec6d b = Vec6d::Zero();
};

/// The contribution of a point with derivatives `J_uv_twist` (rows Jx, Jy) and gradient moments
/// Gxx, Gxy, Gyy.
PointNormal makePointNormal(const Mat26d& J_uv_twist, const Vec3d& gxx_gxy_gyy);

Mat6d unpackHessian(const PackedHessian& packed);

/// Sums in double, in the order of the terms.
NormalEquations accumulateNormals(std::span<const NormalTerm> terms);

/// Solves H delta = b with Jacobi scaling and damping by a 6x6 Cholesky decomposition; nothing when
/// a diagonal entry of H or a pivot is not above 1e-9, or when delta is not finite.
std::optional<Vec6d> solveNormals(const NormalEquations& normals);

}  // namespace glide
