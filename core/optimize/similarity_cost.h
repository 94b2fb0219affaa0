#pragma once

#include "geometry/lie.h"

#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

namespace glide {

/// S_cam_world as Ceres stores it: q_xyzw, t_xyz, log of the scale.
inline constexpr int kSimilaritySize = 8;
inline constexpr int kSimilarityTangent = 7;
using Vec8d = Eigen::Matrix<double, kSimilaritySize, 1>;
Vec8d toSimilarityBlock(const Sim3d& S_cam_world);
Sim3d fromSimilarityBlock(const double* block);

/// S * exp(x) = exp(adjoint(S) * x) * S, for tangents (translation, rotation, log scale).
Mat7d adjoint(const Sim3d& S_a_b);

/// log(exp(d) * exp(x)) = x + J d for small d: the series sum_n B_n / n! ad(x)^n (Bernoulli
/// numbers) up to the twelfth power. Relative error below 1e-6 while rotation and log scale stay
/// below 2, 1e-3 at pi. From the right the derivative is J of -x.
Mat7d leftJacobianInverse(const Vec7d& x);

/// Similarities change by S <- exp(delta) * S, delta = (translation, rotation, log scale), the last
/// at most by 3.
/// SimilarityCost gives its derivative by delta in the first seven of the eight columns, so
/// plusJacobian is [I; 0]: right for that cost only, as LeftPoseManifold is for its own.
class LeftSimilarityManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return kSimilaritySize; }
  int TangentSize() const override { return kSimilarityTangent; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

/// sqrt(weight) * log(S_a_b * S_b_world * S_a_world^-1), by the blocks of a and b: how far the two
/// cameras are from where one was measured in the other (Strasdat, Montiel and Davison, RSS 2010,
/// eq. 8).
class SimilarityCost final
    : public ceres::SizedCostFunction<kSimilarityTangent, kSimilaritySize, kSimilaritySize> {
 public:
  SimilarityCost(const Sim3d& S_a_b, double weight);

  bool Evaluate(const double* const* parameters,
                double* residual,
                double** jacobians) const override;

 private:
  Sim3d S_a_b_;
  double sqrt_weight_;
};

}  // namespace glide
