#pragma once

namespace glide {

/// 95 % quantiles of chi-squared.
inline constexpr double kChi2_1 = 3.841;
inline constexpr double kChi2_2 = 5.991;

/// Huber weight of a residual norm: 1 up to `threshold`, threshold / norm beyond.
inline double huberWeight(double norm, double threshold) {
  return norm <= threshold ? 1.0 : threshold / norm;
}

/// Huber cost of a residual norm: norm^2 up to the threshold, linear beyond.
inline double huberCost(double norm, double threshold) {
  return norm <= threshold ? norm * norm : threshold * (2.0 * norm - threshold);
}

}  // namespace glide
