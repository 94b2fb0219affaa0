#include "optimize/radial_calibration.h"

#include "optimize/residuals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace glide {
namespace {

// The second k1 moves the observations by so much (RMS): well beyond rounding, well within the gate
// that decides about outliers.
constexpr double kProbePx = 0.5;
// Difference quotients by k1: the residual is all but linear in it.
constexpr double kStep = 1e-5;

/// Sum of the inliers' squared residuals when only the lens is changed.
double chi2Under(const CameraModel& camera, const BundleProblem& problem) {
  double sum = 0.0;
  for (const BundleObservation& o : problem.observations) {
    if (!o.inlier) continue;
    const SE3d& T_cam_world = problem.cameras[std::size_t(o.camera)].T_cam_world;
    const Vec3d p_cam = T_cam_world * problem.points[std::size_t(o.point)];
    const std::optional<Vec2d> r = reprojectionResidual(camera, p_cam, o.uv, o.inv_sigma);
    if (r) sum += r->squaredNorm();
  }
  return sum;
}

/// RMS distance between where the two lenses see the observed bearings.
double shiftBetween(const CameraModel& from, const CameraModel& to, const BundleProblem& problem) {
  double sum = 0.0;
  int count = 0;
  for (const BundleObservation& o : problem.observations) {
    const std::optional<Vec3d> bearing = from.unproject(o.uv);
    const std::optional<Vec2d> moved = bearing ? to.project(*bearing) : std::nullopt;
    if (!moved) continue;
    sum += (*moved - o.uv).squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

/// Adjusts the bundle under the lens and returns how its chi2 would change with k1. Everything else
/// being at its optimum, the derivative of the adjusted chi2 is the partial one.
std::optional<double> profileSlope(const CameraModel& camera,
                                   const BundleOptions& options,
                                   BundleProblem* problem) {
  const BundleSummary summary = solveBundle(camera, options, problem);
  if (!summary.usable || summary.cancelled) return std::nullopt;
  return (chi2Under(withRadial(camera, kStep), *problem) -
          chi2Under(withRadial(camera, -kStep), *problem)) /
         (2.0 * kStep);
}

}  // namespace

CameraModel withRadial(const CameraModel& camera, double dk1) {
  CameraIntrinsics intrinsics = camera.intrinsics();
  if (intrinsics.distortion == DistortionModel::none) {
    intrinsics.distortion = DistortionModel::radial_tangential;
    intrinsics.coefficients.assign(4, 0.0);
  }
  intrinsics.coefficients.front() += dk1;
  const Result<CameraModel> changed = CameraModel::create(intrinsics);
  assert(changed.ok());
  return *changed;
}

std::optional<RadialCorrection> estimateRadial(const CameraModel& camera,
                                               const BundleOptions& options,
                                               BundleProblem problem) {
  const double px_per_dk1 = shiftBetween(camera, withRadial(camera, kStep), problem) / kStep;
  if (!(px_per_dk1 > 0.0)) return std::nullopt;
  const std::optional<double> slope = profileSlope(camera, options, &problem);
  if (!slope) return std::nullopt;
  const double probe = std::copysign(kProbePx / px_per_dk1, -*slope);
  const std::optional<double> probed = profileSlope(withRadial(camera, probe), options, &problem);
  if (!probed) return std::nullopt;
  const double curvature = (*probed - *slope) / probe;  // chi2 = ((k1 - best) / sigma)^2 + ...
  if (!(curvature > 0.0)) return std::nullopt;

  RadialCorrection correction;
  correction.dk1 = -*slope / curvature;
  correction.sigma = std::sqrt(2.0 / curvature);
  correction.shift_px = shiftBetween(camera, withRadial(camera, correction.dk1), problem);
  return correction;
}

}  // namespace glide
