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
// Steps between values of k1 (RMS of the observations): far ones leave what the bundle can follow
// in one solve, small ones end the search.
constexpr double kMaxStepPx = 2.0;
constexpr double kConvergedPx = 0.02;
constexpr int kMaxSolves = 10;
// Difference quotients by k1: the residual is all but linear in it.
constexpr double kStep = 1e-5;

/// Sum of the squared residuals when only the lens is changed.
double chi2Under(const CameraModel& camera, const BundleProblem& problem) {
  double sum = 0.0;
  for (const BundleObservation& o : problem.observations) {
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

bool adjust(const CameraModel& camera, const BundleOptions& options, BundleProblem* problem) {
  const BundleSummary summary = solveBundle(camera, options, problem);
  return summary.usable && !summary.cancelled;
}

void removeOutliers(BundleProblem* problem) {
  std::vector<BundleObservation>& all = problem->observations;
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& o) { return !o.inlier; }),
            all.end());
}

/// Adjusts the bundle to all of its observations under the lens, and returns how its chi2 would
/// change with k1. Everything else being at its optimum, the derivative of the adjusted chi2 is the
/// partial one.
std::optional<double> profileSlope(const CameraModel& camera,
                                   const BundleOptions& options,
                                   BundleProblem* problem) {
  BundleOptions squared = options;
  squared.rounds = 1;  // no gate: what is compared has to be the sum over the same observations
  for (BundleObservation& o : problem->observations) o.inlier = true;
  if (!adjust(camera, squared, problem)) return std::nullopt;
  return (chi2Under(withRadial(camera, kStep), *problem) -
          chi2Under(withRadial(camera, -kStep), *problem)) /
         (2.0 * kStep);
}

/// Looks for the k1 at which the slope of the profile is zero.
struct Secant {
  double before = 0.0, slope_before = 0.0;
  double dk1 = 0.0;        ///< to be tried next
  double curvature = 0.0;  ///< chi2 = ((dk1 - best) / sigma)^2 + ..., so 2 / sigma^2

  /// Takes the slope at dk1. False where the profile bends the wrong way.
  bool advance(double slope, double max_step) {
    curvature = (slope - slope_before) / (dk1 - before);
    if (!(curvature > 0.0)) return false;
    before = dk1;
    slope_before = slope;
    dk1 += std::clamp(-slope / curvature, -max_step, max_step);
    return true;
  }
};

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
  if (!(px_per_dk1 > 0.0) || !adjust(camera, options, &problem)) return std::nullopt;
  removeOutliers(&problem);
  const std::optional<double> slope = profileSlope(camera, options, &problem);
  if (!slope) return std::nullopt;

  Secant secant{0.0, *slope, std::copysign(kProbePx / px_per_dk1, -*slope)};
  for (int solves = 1; solves < kMaxSolves; ++solves) {
    const auto next = profileSlope(withRadial(camera, secant.dk1), options, &problem);
    if (!next || !secant.advance(*next, kMaxStepPx / px_per_dk1)) return std::nullopt;
    if (std::abs(secant.dk1 - secant.before) * px_per_dk1 > kConvergedPx) continue;
    return RadialCorrection{secant.dk1,
                            std::sqrt(2.0 / secant.curvature),
                            shiftBetween(camera, withRadial(camera, secant.dk1), problem)};
  }
  return std::nullopt;
}

}  // namespace glide
