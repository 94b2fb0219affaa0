#pragma once

#include "geometry/eigen_types.h"

#include "glide/types.h"

#include <array>
#include <optional>

namespace glide {

/// The lens models on the normalised plane, for CameraModel only. Formulas stand in
/// camera_model.cpp. k1, k2, p1, p2, k3 or k1..k4, zero.
using DistortionCoefficients = std::array<double, 5>;

/// x^2 + y^2 beyond which a ray counts as parallel to the image plane (89.99 degrees): keeps the
/// radial polynomial finite.
inline constexpr double kMaxTangentSquared = 1e8;

/// A distorted point of the normalised plane and its derivative by the undistorted one.
struct DistortedPoint {
  Vec2d xy;
  Mat2d J_distorted_xy;
};

Vec2d distortRadialTangential(const DistortionCoefficients& k, const Vec2d& xy);
DistortedPoint distortWithJacobian(const DistortionCoefficients& k, const Vec2d& xy);

/// Distorted angle of an angle to the optical axis (radians), and its derivative.
double kannalaBrandt(const DistortionCoefficients& k, double theta);
double kannalaBrandtDerivative(const DistortionCoefficients& k, double theta);

/// See CameraModel::maxRadius(): where the derivative of the distorted radius first is zero.
double monotonicLimit(DistortionModel model, const DistortionCoefficients& k);

/// Unit bearing of a distorted point of the normalised plane; `limit` is monotonicLimit(). Nothing
/// when the point lies beyond what the model reaches.
std::optional<Vec3d> unprojectRadialTangential(const DistortionCoefficients& k,
                                               const Vec2d& distorted,
                                               double limit);
std::optional<Vec3d> unprojectKannalaBrandt(const DistortionCoefficients& k,
                                            const Vec2d& distorted,
                                            double limit);

}  // namespace glide
