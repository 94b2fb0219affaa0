// The essential graph of a loop: cameras around a circle with scale drift, each joined to the ten
// before it, and one loop edge with its neighbours. Run with glide_bench
// --benchmark_filter=poseGraph.
#include "optimize/pose_graph.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

constexpr int kEdgesPerCamera = 10;
constexpr double kTurn = 6.283185307179586;
constexpr double kStep = 0.5;         // scene units between cameras
constexpr double kScaleDrift = 1e-3;  // of the logarithm, per step

Sim3d onCircle(int i, int count) {
  const double angle = kTurn * i / count;
  const double radius = kStep * count / kTurn;
  return Sim3d{
      so3Exp(Vec3d(0.0, -angle, 0.0)), radius * Vec3d(std::cos(angle), 0.0, std::sin(angle)), 1.0}
      .inverse();
}

PoseGraph driftingGraph(int count) {
  PoseGraph graph;
  const Sim3d S_drift{Eigen::Quaterniond::Identity(), Vec3d::Zero(), std::exp(kScaleDrift)};
  graph.vertices.push_back({onCircle(0, count), true});
  for (int i = 1; i < count; ++i) {
    const Sim3d S_step = onCircle(i, count) * onCircle(i - 1, count).inverse();
    graph.vertices.push_back({S_drift * S_step * graph.vertices.back().S_cam_world});
    for (int j = std::max(0, i - kEdgesPerCamera); j < i; ++j) {
      const auto& S_j = graph.vertices[std::size_t(j)].S_cam_world;
      graph.edges.push_back({j, i, S_j * graph.vertices.back().S_cam_world.inverse()});
    }
  }
  for (int i = 0; i < kEdgesPerCamera; ++i) {
    graph.edges.push_back(
        {count - 1, i, onCircle(count - 1, count) * onCircle(i, count).inverse()});
  }
  return graph;
}

void poseGraph(benchmark::State& state) {
  const PoseGraph start = driftingGraph(int(state.range(0)));
  PoseGraphSummary summary;
  for ([[maybe_unused]] auto _ : state) {
    PoseGraph graph = start;
    summary = solvePoseGraph({}, &graph);
  }
  state.counters["edges"] = double(start.edges.size());
  state.counters["iterations"] = summary.iterations;
  state.counters["initial_cost"] = summary.initial_cost;
  state.counters["final_cost"] = summary.final_cost;
}

BENCHMARK(poseGraph)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
