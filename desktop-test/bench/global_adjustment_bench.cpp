// Global bundle adjustment of a walk once around a ring of corners, bent as a pose graph leaves it.
// Run with glide_bench --benchmark_filter=globalAdjustment.
#include "optimize/global_adjustment.h"

#include "support/true_map.h"

#include "map/map_correction.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kStep = 0.3;     // scene units between keyframes
constexpr double kDepth = 5.0;    // of the ring of corners beyond the cameras' circle
constexpr double kDensity = 0.8;  // corners per cubic unit: some 300 of them in a view

/// `count` keyframes on a circle that look outwards.
test::TrueMap ring(int count) {
  const double radius = kStep * count / kTurn;
  const double reach = radius + 2.0 * kDepth;
  test::SyntheticCloudOptions options;
  options.low = Vec3d(-reach, -3.0, -reach);
  options.high = Vec3d(reach, 3.0, reach);
  options.points = int(kDensity * 24.0 * reach * reach);
  options.hole = radius + 2.0;
  options.noise_px = 0.5;
  options.missed_share = 0.3;
  test::TrueMap world(options);
  for (int i = 0; i < count; ++i) {
    const double yaw = kTurn * i / count;
    world.addKeyframe(test::lookAlong(radius * Vec3d(std::sin(yaw), 0.0, std::cos(yaw)), yaw));
  }
  world.bend(0.05 * radius, 0.5 * radius);
  return world;
}

double worstError(const test::TrueMap& world) {
  double worst = 0.0;
  for (const auto& [id, keyframe] : world.map.keyframes()) {
    const Vec3d center = keyframe.T_cam_world.inverse().t;
    worst = std::max(worst, (center - world.truePose(id).inverse().t).norm());
  }
  return worst;
}

void globalAdjustment(benchmark::State& state) {
  const test::TrueMap world = ring(int(state.range(0)));
  const auto snapshot = world.snapshot();
  std::optional<GlobalAdjustment> adjustment;
  GlobalAdjustmentOptions options{ScaleLevels(1.2, 8)};
  options.max_iterations = int(state.range(1));
  for ([[maybe_unused]] auto _ : state) {
    adjustment = adjustGlobally(world.cloud.camera(), *snapshot, options);
  }
  std::size_t observations = 0;
  for (const auto& landmark : snapshot->landmarks()) observations += landmark.observations.size();
  state.counters["landmarks"] = double(snapshot->landmarks().size());
  state.counters["per_keyframe"] = double(observations) / double(snapshot->keyframes().size());
  state.counters["error_before"] = worstError(world);
  test::TrueMap adjusted = world;
  if (adjustment) applyAdjustment(*adjustment, &adjusted.map);
  state.counters["error_after"] = worstError(adjusted);
}

BENCHMARK(globalAdjustment)->Args({100, 10})->Args({300, 10})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
