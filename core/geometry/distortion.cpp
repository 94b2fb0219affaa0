#include "geometry/distortion.h"

#include "geometry/polynomial.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace glide {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Newton's steps end below this error on the normalised plane (1e-10 px at a focal length of 1e4);
/// what stays above kAccepted has not converged.
constexpr double kConverged = 1e-14;
constexpr double kAccepted = 1e-12;
constexpr int kMaxNewtonSteps = 20;

/// Newton's method converges quadratically: after a step this small the next one is rounding error.
constexpr double kRelativeStep = 1e-10;

double radialFactor(const DistortionCoefficients& k, double r2) {
  return 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
}

/// Derivative of r * radialFactor(r^2) by r.
double radialDerivative(const DistortionCoefficients& k, double r2) {
  return 1.0 + r2 * (3.0 * k[0] + r2 * (5.0 * k[1] + r2 * 7.0 * k[4]));
}

/// An x with f(x) >= value, at most x_max; nothing when there is none.
template <class F>
std::optional<double> upperBracket(const F& f, double value, double x_max) {
  if (std::isfinite(x_max)) return value <= f(x_max) ? std::optional(x_max) : std::nullopt;
  double high = 1.0;
  while (f(high) < value) {
    high *= 2.0;
    if (high * high > kMaxTangentSquared) return std::nullopt;
  }
  return high;
}

/// The x in 0..x_max with f(x) = value for a rising f with f(0) = 0 (Newton, kept inside a
/// shrinking bracket); nothing when value lies beyond f(x_max).
template <class F, class Derivative>
std::optional<double> invertRising(const F& f, const Derivative& df, double value, double x_max) {
  const std::optional<double> upper = upperBracket(f, value, x_max);
  if (!upper) return std::nullopt;
  double low = 0.0;
  double high = *upper;
  double x = std::min(value, high);
  constexpr int kMaxSteps = 100;  // bisection alone needs 60
  for (int i = 0; i < kMaxSteps; ++i) {
    const double error = f(x) - value;
    (error > 0.0 ? high : low) = x;
    const double newton = x - error / df(x);
    if (std::abs(newton - x) <= kRelativeStep * x) return newton;
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return x;
}

/// Newton's method from a start; nothing when it does not converge.
std::optional<Vec2d> undistortFrom(const DistortionCoefficients& k,
                                   const Vec2d& distorted,
                                   const Vec2d& start) {
  Vec2d xy = start;
  for (int i = 0; i < kMaxNewtonSteps; ++i) {
    const DistortedPoint point = distortWithJacobian(k, xy);
    const Vec2d residual = point.xy - distorted;
    if (residual.squaredNorm() < kConverged * kConverged) return xy;
    xy -= point.J_distorted_xy.inverse() * residual;
  }
  const double error = (distortRadialTangential(k, xy) - distorted).norm();
  return error < kAccepted ? std::optional(xy) : std::nullopt;
}

}  // namespace

Vec2d distortRadialTangential(const DistortionCoefficients& k, const Vec2d& xy) {
  const double x = xy.x();
  const double y = xy.y();
  const double r2 = x * x + y * y;
  const double g = radialFactor(k, r2);
  return {x * g + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x),
          y * g + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y};
}

DistortedPoint distortWithJacobian(const DistortionCoefficients& k, const Vec2d& xy) {
  const double x = xy.x();
  const double y = xy.y();
  const double r2 = x * x + y * y;
  const double g = radialFactor(k, r2);
  const double dg = 2.0 * (k[0] + r2 * (2.0 * k[1] + 3.0 * r2 * k[4]));  // dg/dx = dg * x
  const double mixed = dg * x * y + 2.0 * (k[2] * x + k[3] * y);
  DistortedPoint out;
  out.xy = distortRadialTangential(k, xy);
  out.J_distorted_xy << g + dg * x * x + 2.0 * k[2] * y + 6.0 * k[3] * x, mixed,  //
      mixed, g + dg * y * y + 6.0 * k[2] * y + 2.0 * k[3] * x;
  return out;
}

double kannalaBrandt(const DistortionCoefficients& k, double theta) {
  const double t2 = theta * theta;
  return theta * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
}

double kannalaBrandtDerivative(const DistortionCoefficients& k, double theta) {
  const double t2 = theta * theta;
  return 1.0 + t2 * (3.0 * k[0] + t2 * (5.0 * k[1] + t2 * (7.0 * k[2] + t2 * 9.0 * k[3])));
}

double monotonicLimit(DistortionModel model, const DistortionCoefficients& k) {
  if (model == DistortionModel::radial_tangential) {
    const Quartic derivative{1.0, 3.0 * k[0], 5.0 * k[1], 7.0 * k[4], 0.0};  // in r^2
    const std::vector<double> folds = rootsBetween(derivative, 0.0, kMaxTangentSquared);
    return folds.empty() ? kInfinity : folds.front();
  }
  if (model == DistortionModel::kannala_brandt4) {
    const Quartic derivative{1.0, 3.0 * k[0], 5.0 * k[1], 7.0 * k[2], 9.0 * k[3]};  // in theta^2
    const std::vector<double> folds = rootsBetween(derivative, 0.0, kPi * kPi);
    return folds.empty() ? kPi : std::sqrt(folds.front());
  }
  return kInfinity;
}

std::optional<Vec3d> unprojectRadialTangential(const DistortionCoefficients& k,
                                               const Vec2d& distorted,
                                               double limit) {
  std::optional<Vec2d> xy = undistortFrom(k, distorted, distorted);
  if (!xy || !(xy->squaredNorm() <= limit)) {
    // Strong distortion: start from the radial part alone, which always converges.
    const double distorted_radius = distorted.norm();
    const std::optional<double> radius =
        invertRising([&](double r) { return r * radialFactor(k, r * r); },
                     [&](double r) { return radialDerivative(k, r * r); },
                     distorted_radius,
                     std::sqrt(limit));
    if (!radius) return std::nullopt;
    xy = undistortFrom(k, distorted, distorted * (*radius / distorted_radius));
    if (!xy || !(xy->squaredNorm() <= limit)) return std::nullopt;
  }
  return Vec3d(xy->x(), xy->y(), 1.0).normalized();
}

std::optional<Vec3d> unprojectKannalaBrandt(const DistortionCoefficients& k,
                                            const Vec2d& distorted,
                                            double limit) {
  const double theta_d = distorted.norm();
  if (theta_d < std::numeric_limits<double>::min()) return Vec3d::UnitZ();
  const std::optional<double> theta =
      invertRising([&](double angle) { return kannalaBrandt(k, angle); },
                   [&](double angle) { return kannalaBrandtDerivative(k, angle); },
                   theta_d,
                   limit);
  if (!theta) return std::nullopt;
  const Vec2d xy = distorted * (std::sin(*theta) / theta_d);
  return Vec3d(xy.x(), xy.y(), std::cos(*theta));
}

}  // namespace glide
