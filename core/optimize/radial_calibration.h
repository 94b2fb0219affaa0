#pragma once

#include "optimize/bundle_problem.h"

#include "geometry/camera_model.h"

#include <optional>

namespace glide {

/// How far a lens is from its calibration, as the points of a bundle tell it: an addition to k1,
/// the first radial coefficient of every lens model.
struct RadialCorrection {
  double dk1 = 0.0;
  double sigma = 0.0;     ///< standard deviation of dk1, given the sigmas of the observations
  double shift_px = 0.0;  ///< how far it moves the observations: RMS, px
};

/// The same camera with k1 + dk1 (finite); a pinhole becomes radial-tangential.
CameraModel withRadial(const CameraModel& camera, double dk1);

/// The correction under which the bundle fits best, by the profile of its likelihood: the bundle is
/// adjusted for two values of k1 (docs/algorithms/self-calibration.md). At least one of its
/// cameras is fixed. Nothing when a solve fails or the bundle does not hold the coefficient.
std::optional<RadialCorrection> estimateRadial(const CameraModel& camera,
                                               const BundleOptions& options,
                                               BundleProblem problem);

}  // namespace glide
