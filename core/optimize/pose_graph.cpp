#include "optimize/pose_graph.h"

#include "optimize/ceres_setup.h"
#include "optimize/similarity_cost.h"

#include <cassert>
#include <cstddef>
#include <deque>
#include <exception>

namespace glide {
namespace {

// Relative decrease of the cost at which the solve ends; it alone decides, since a test on the
// length of the step would depend on the map's scale.
constexpr double kFunctionTolerance = 1e-6;
constexpr double kParameterTolerance = 0.0;
// Nearly Gauss-Newton: a long chain is so soft against bending that the usual damping (1e4) would
// hold it, 20 iterations instead of 3 for 1000 cameras.
constexpr double kInitialTrustRegion = 1e10;

/// A ceres::Problem and what it points to.
struct GraphProblem {
  std::vector<Vec8d> blocks;         // per vertex
  std::deque<SimilarityCost> costs;  // neither copied nor moved
  LeftSimilarityManifold manifold;
  ceres::Problem problem{borrowingEverything()};
  int free_vertices = 0;
};

void build(const PoseGraph& graph, GraphProblem* target) {
  target->blocks.reserve(graph.vertices.size());
  for (const PoseGraph::Vertex& vertex : graph.vertices) {
    target->blocks.push_back(toSimilarityBlock(vertex.S_cam_world));
  }
  for (const PoseGraph::Edge& edge : graph.edges) {
    target->costs.emplace_back(edge.S_a_b, edge.weight);
    target->problem.AddResidualBlock(&target->costs.back(),
                                     nullptr,
                                     target->blocks[std::size_t(edge.a)].data(),
                                     target->blocks[std::size_t(edge.b)].data());
  }
  for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
    double* block = target->blocks[i].data();
    if (!target->problem.HasParameterBlock(block)) continue;
    if (graph.vertices[i].fixed) {
      target->problem.SetParameterBlockConstant(block);
    } else {
      target->problem.SetManifold(block, &target->manifold);
      ++target->free_vertices;
    }
  }
}

void writeBack(const GraphProblem& solved, PoseGraph* graph) {
  for (std::size_t i = 0; i < graph->vertices.size(); ++i) {
    PoseGraph::Vertex& vertex = graph->vertices[i];
    if (vertex.fixed || !solved.problem.HasParameterBlock(solved.blocks[i].data())) continue;
    vertex.S_cam_world = fromSimilarityBlock(solved.blocks[i].data());
  }
}

ceres::Solver::Options solverOptions(const PoseGraphOptions& options) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  ceres_options.sparse_linear_algebra_library_type = kSparseLibrary;
  ceres_options.initial_trust_region_radius = kInitialTrustRegion;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.function_tolerance = kFunctionTolerance;
  ceres_options.parameter_tolerance = kParameterTolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  return ceres_options;
}

PoseGraphSummary solve(const PoseGraphOptions& options, PoseGraph* graph) {
  GraphProblem problem;
  build(*graph, &problem);
  PoseGraphSummary result;
  if (problem.free_vertices == 0) return result;

  ceres::Solver::Options ceres_options = solverOptions(options);
  CancelCallback callback(options.cancel, ceres::SOLVER_ABORT);
  ceres_options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem.problem, &summary);

  result.initial_cost = summary.initial_cost;
  result.final_cost = summary.final_cost;
  if (!summary.iterations.empty()) result.iterations = summary.iterations.back().iteration;
  result.cancelled = isCancelled(options.cancel);
  result.usable = summary.IsSolutionUsable() && !result.cancelled;
  if (result.usable) writeBack(problem, graph);
  return result;
}

}  // namespace

PoseGraphSummary solvePoseGraph(const PoseGraphOptions& options, PoseGraph* graph) {
  try {
    return solve(options, graph);
  } catch (const std::exception&) {
    return PoseGraphSummary{};  // Ceres or the allocator gave up; the graph is written at the end
                                // only.
  }
}

Sim3d worldMove(const Sim3d& S_cam_world_old, const Sim3d& S_cam_world_new) {
  return S_cam_world_new.inverse() * S_cam_world_old;
}

std::vector<KeyframeMove> keyframeMoves(std::span<const KeyframeId> ids,
                                        const PoseGraph& before,
                                        const PoseGraph& after) {
  assert(ids.size() == before.vertices.size() && ids.size() == after.vertices.size());
  std::vector<KeyframeMove> moves;
  moves.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    moves.push_back(
        {ids[i], worldMove(before.vertices[i].S_cam_world, after.vertices[i].S_cam_world)});
  }
  return moves;
}

}  // namespace glide
