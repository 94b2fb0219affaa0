// Motion-only optimisation of one frame with 20 % outliers, a guess as far off as a bad prediction
// is.
#include "support/synthetic_problem.h"

#include "optimize/pose_optimizer.h"

#include <benchmark/benchmark.h>

namespace glide {
namespace {

void optimizePoseOfFrame(benchmark::State& state, DistortionModel distortion) {
  const CameraModel camera = test::syntheticCamera(distortion);
  const test::SyntheticProblem truth = test::makeSyntheticProblem(
      camera, {.cameras = 1, .points = int(state.range(0)), .noise_px = 0.7, .outlier_share = 0.2});
  std::vector<PoseObservation> observations;
  for (const test::SyntheticObservation& o : truth.observations) {
    observations.push_back({truth.points[std::size_t(o.point)], o.uv, 1.0});
  }
  std::mt19937_64 rng(1);
  const SE3d guess = test::perturbed(truth.T_cam_world[0], 0.05, 0.02, &rng);
  PoseEstimate estimate;
  for ([[maybe_unused]] auto _ : state) {
    estimate = optimizePose(camera, guess, observations);
    benchmark::DoNotOptimize(estimate);
  }
  state.counters["inliers"] = estimate.inliers;
}

BENCHMARK_CAPTURE(optimizePoseOfFrame, pinhole, DistortionModel::none)
    ->Arg(200)
    ->Arg(600)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(optimizePoseOfFrame, radtan, DistortionModel::radial_tangential)
    ->Arg(200)
    ->Arg(600)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(optimizePoseOfFrame, kannala_brandt, DistortionModel::kannala_brandt4)
    ->Arg(200)
    ->Arg(600)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace glide
