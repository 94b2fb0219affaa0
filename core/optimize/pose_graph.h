#pragma once

#include "map/messages.h"

#include "base/ids.h"
#include "geometry/lie.h"

#include <atomic>
#include <span>
#include <vector>

namespace glide {

/// Cameras held together by measured similarities between pairs of them; plain arrays, solved in
/// place (Strasdat, Montiel and Davison, "Scale drift-aware large scale monocular SLAM", RSS 2010).
struct PoseGraph {
  struct Vertex {
    Sim3d S_cam_world;   ///< scale 1 before the solve, if the map is what the map says
    bool fixed = false;  ///< at least one of each connected part
  };
  /// Camera b was measured in camera a: p_a = S_a_b * p_b.
  struct Edge {
    int a = 0, b = 0;  ///< vertices, different ones
    Sim3d S_a_b;
    double weight = 1.0;  ///< of the squared residual, > 0
  };
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
};

struct PoseGraphOptions {
  int max_iterations = 20;
  const std::atomic<bool>* cancel = nullptr;  ///< may be null; checked once per iteration
};

struct PoseGraphSummary {
  double initial_cost = 0.0, final_cost = 0.0;  ///< half the weighted sum of squares
  int iterations = 0;
  bool usable = false;  ///< false: nothing was changed
  bool cancelled = false;
};

/// Minimises sum weight |log(S_a_b * S_b_world * S_a_world^-1)|^2 over the free vertices, 7 degrees
/// of freedom each (Ceres, analytic Jacobians, sparse Cholesky, one thread, the same bits each
/// time). Not usable without a free vertex, without edges, or when cancelled.
/// docs/algorithms/loop-closing.md.
PoseGraphSummary solvePoseGraph(const PoseGraphOptions& options, PoseGraph* graph);

/// What the world around a camera does when the camera goes from one similarity to the other and
/// takes along what it sees: S_new_old = S_cam_world_new^-1 * S_cam_world_old.
Sim3d worldMove(const Sim3d& S_cam_world_old, const Sim3d& S_cam_world_new);

/// The move of every vertex of a solved graph. `ids`, ascending, names the vertices; `before` is
/// the graph with the poses that the map has.
std::vector<KeyframeMove> keyframeMoves(std::span<const KeyframeId> ids,
                                        const PoseGraph& before,
                                        const PoseGraph& after);

}  // namespace glide
