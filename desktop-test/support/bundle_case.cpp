#include "support/bundle_case.h"

#include <algorithm>

namespace glide::test {
namespace {

// As far off as a new keyframe and fresh points are: some pixels.
constexpr double kTranslationSigma = 0.03;
constexpr double kRotationSigmaRad = 0.01;
constexpr double kPointSigma = 0.05;

}  // namespace

BundleCase makeBundleCase(const CameraModel& camera, const SyntheticOptions& options) {
  BundleCase bundle{makeSyntheticProblem(camera, options), {}};
  std::mt19937_64 rng(options.seed + 1);
  for (std::size_t c = 0; c < bundle.truth.T_cam_world.size(); ++c) {
    const SE3d& T_truth = bundle.truth.T_cam_world[c];
    const bool fixed = c < 2;
    const SE3d T_start =
        fixed ? T_truth : perturbed(T_truth, kTranslationSigma, kRotationSigmaRad, &rng);
    bundle.problem.cameras.push_back({T_start, fixed});
  }
  for (const Vec3d& p_world : bundle.truth.points) {
    bundle.problem.points.push_back(p_world + randomVector(kPointSigma, &rng));
  }
  for (const SyntheticObservation& o : bundle.truth.observations) {
    bundle.problem.observations.push_back({o.camera, o.point, o.uv, 1.0, true});
  }
  return bundle;
}

double worstCameraError(const BundleCase& bundle) {
  double worst = 0.0;
  for (std::size_t c = 0; c < bundle.problem.cameras.size(); ++c) {
    const SE3d error =
        bundle.problem.cameras[c].T_cam_world * bundle.truth.T_cam_world[c].inverse();
    worst = std::max(worst, error.log().norm());
  }
  return worst;
}

double worstPointError(const BundleCase& bundle) {
  double worst = 0.0;
  for (std::size_t p = 0; p < bundle.problem.points.size(); ++p) {
    worst = std::max(worst, (bundle.problem.points[p] - bundle.truth.points[p]).norm());
  }
  return worst;
}

double sumOfSquares(const CameraModel& camera, const BundleProblem& problem) {
  double sum = 0.0;
  for (const BundleObservation& o : problem.observations) {
    const SE3d& T_cam_world = problem.cameras[std::size_t(o.camera)].T_cam_world;
    const Vec3d p_cam = T_cam_world * problem.points[std::size_t(o.point)];
    sum += ((camera.project(p_cam).value() - o.uv) * o.inv_sigma).squaredNorm();
  }
  return sum;
}

}  // namespace glide::test
