// Local bundle adjustment as the mapper asks for it: N free and 20 fixed cameras, 2000 points,
// 10000 observations, 5 % of them outliers, a start that is some pixels off. Run with glide_bench
// --benchmark_filter=localBundle.
#include "support/bundle_case.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace glide {
namespace {

constexpr int kFixedCameras = 20;

test::BundleCase localCase(const CameraModel& camera, int free_cameras) {
  test::BundleCase bundle = test::makeBundleCase(camera,
                                                 {.cameras = free_cameras + kFixedCameras,
                                                  .points = 2000,
                                                  .max_views_per_point = 5,
                                                  .noise_px = 0.7,
                                                  .outlier_share = 0.05});
  for (int c = 0; c < kFixedCameras; ++c) {
    // Every second camera from the start, so that free ones have fixed neighbours.
    const auto index = std::size_t(std::min(2 * c, free_cameras + kFixedCameras - 1));
    bundle.problem.cameras[index] = {bundle.truth.T_cam_world[index], true};
  }
  return bundle;
}

void localBundle(benchmark::State& state, DistortionModel distortion) {
  const CameraModel camera = test::syntheticCamera(distortion);
  const test::BundleCase start = localCase(camera, int(state.range(0)));
  BundleSummary summary;
  test::BundleCase solved = start;
  for ([[maybe_unused]] auto _ : state) {
    solved.problem = start.problem;
    summary = solveBundle(camera, {}, &solved.problem);
  }
  state.counters["observations"] = double(start.problem.observations.size());
  state.counters["iterations"] = summary.iterations;
  state.counters["outliers"] = summary.outliers;
  state.counters["final_cost"] = summary.final_cost;
  state.counters["camera_error"] = test::worstCameraError(solved);
}

BENCHMARK_CAPTURE(localBundle, radtan, DistortionModel::radial_tangential)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(localBundle, kannala_brandt, DistortionModel::kannala_brandt4)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
