// The steps of local mapping on a synthetic walk: 20 keyframes of about 1000 features, the next one
// inserted. Run with glide_bench --benchmark_filter=Mapping.
#include "support/mapped_scene.h"

#include "mapping/fusion.h"
#include "mapping/keyframe_culling.h"
#include "mapping/new_landmarks.h"
#include "mapping/window_adjustment.h"

#include "map/snapshot_builder.h"

#include <benchmark/benchmark.h>

namespace glide {
namespace {

using test::walk;

constexpr int kKeyframes = 20;

test::SyntheticCloudOptions benchCloud() {
  test::SyntheticCloudOptions options;
  options.points = 4000;
  options.noise_px = 0.5;
  options.flipped_bits = 12;
  options.missed_share = 0.3;
  return options;
}

/// A mapped walk of kKeyframes whose newest keyframe is inserted, but not used yet.
struct PreparedWalk {
  PreparedWalk() : scene(benchCloud(), {}) {
    scene.start();
    for (int step = 2; step < kKeyframes; ++step) {
      newest = scene.insert(walk(step));
      createLandmarks(&scene.state, newest, nullptr);
      fuseAround(&scene.state, newest, nullptr);
      adjustWindow(&scene.state, windowAround(scene.state.map, newest, kKeyframes), {});
    }
    newest = scene.insert(walk(kKeyframes));
    createLandmarks(
        &scene.state, newest, nullptr);  // fills the cache of bearings, as a real run has
    for (const LandmarkId id : scene.state.map.landmarkIds()) {
      const bool is_new = scene.state.map.landmark(id)->first_keyframe == newest;
      if (is_new) scene.state.map.removeLandmark(id);
    }
  }

  test::MappedScene scene;
  KeyframeId newest;
};

const MapperState& prepared(KeyframeId* newest) {
  static const PreparedWalk walk;
  *newest = walk.newest;
  return walk.scene.state;
}

template <class Step>
void runStep(benchmark::State& bench, Step step) {
  KeyframeId newest;
  const MapperState& start = prepared(&newest);
  for ([[maybe_unused]] auto _ : bench) {
    bench.PauseTiming();
    MapperState state = start;
    bench.ResumeTiming();
    step(&state, newest);
  }
  bench.counters["landmarks"] = static_cast<double>(start.map.landmarkCount());
  bench.counters["features"] = static_cast<double>(start.map.keyframe(newest)->features->size());
}

void BM_MappingNewLandmarks(benchmark::State& bench) {
  runStep(bench, [](MapperState* state, KeyframeId id) {
    benchmark::DoNotOptimize(createLandmarks(state, id, nullptr));
  });
}
BENCHMARK(BM_MappingNewLandmarks)->Unit(benchmark::kMillisecond);

void BM_MappingFusion(benchmark::State& bench) {
  runStep(bench, [](MapperState* state, KeyframeId id) { fuseAround(state, id, nullptr); });
}
BENCHMARK(BM_MappingFusion)->Unit(benchmark::kMillisecond);

void BM_MappingAdjustment(benchmark::State& bench) {
  runStep(bench, [](MapperState* state, KeyframeId id) {
    adjustWindow(state, windowAround(state->map, id, kKeyframes), {});
  });
}
BENCHMARK(BM_MappingAdjustment)->Unit(benchmark::kMillisecond);

void BM_MappingCulling(benchmark::State& bench) {
  runStep(bench, [](MapperState* state, KeyframeId id) { cullRedundantKeyframes(state, id); });
}
BENCHMARK(BM_MappingCulling)->Unit(benchmark::kMillisecond);

void BM_MappingSnapshot(benchmark::State& bench) {
  runStep(bench, [](MapperState* state, KeyframeId) {
    benchmark::DoNotOptimize(
        snapshotOf(state->map, {1, 1, 0, state->config.mapping.min_covisibility}));
  });
}
BENCHMARK(BM_MappingSnapshot)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
