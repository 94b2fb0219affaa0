#pragma once

#include "support/synthetic_problem.h"

#include "optimize/bundle_problem.h"

namespace glide::test {

/// A bundle whose start is off from the truth. The first two cameras are fixed at the truth, which
/// fixes the gauge, so the solution can be compared with the truth directly.
struct BundleCase {
  SyntheticProblem truth;
  BundleProblem problem;
};

BundleCase makeBundleCase(const CameraModel& camera, const SyntheticOptions& options);

/// Largest norm of log(T * T_truth^-1) over the cameras, and largest distance over the points.
double worstCameraError(const BundleCase& bundle);
double worstPointError(const BundleCase& bundle);

/// Of all residuals in sigmas; every point must project.
double sumOfSquares(const CameraModel& camera, const BundleProblem& problem);

}  // namespace glide::test
