#include "loop/loop_correction.h"

#include "optimize/pose_graph.h"

#include <cstddef>
#include <unordered_map>
#include <utility>

namespace glide {
namespace {

// Shared landmarks from which a link holds two keyframes together although the tree does not need
// it: strong ones make the graph stiff, weak ones only slow.
constexpr int kMinLinkWeight = 60;

/// The graph before the solve, as the map has it.
class GraphBuilder {
 public:
  explicit GraphBuilder(const MapSnapshot& map) : map_(map) {
    for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
      index_[keyframe.id] = static_cast<int>(graph_.vertices.size());
      const SE3d& T_cam_world = keyframe.T_cam_world;
      graph_.vertices.push_back({{T_cam_world.q, T_cam_world.t, 1.0}, false});
    }
    graph_.vertices.front().fixed = true;
  }

  /// As it is in the map.
  void addLink(KeyframeId a, KeyframeId b) {
    if (a == b || map_.keyframe(a) == nullptr || map_.keyframe(b) == nullptr) return;
    const SE3d T_a_b = map_.keyframe(a)->T_cam_world * map_.keyframe(b)->T_cam_world.inverse();
    addMeasured(a, b, {T_a_b.q, T_a_b.t, 1.0});
  }

  void addMeasured(KeyframeId a, KeyframeId b, const Sim3d& S_a_b) {
    PoseGraph::Edge edge;
    edge.a = index_.at(a);
    edge.b = index_.at(b);
    edge.S_a_b = S_a_b;
    graph_.edges.push_back(edge);
  }

  PoseGraph take() { return std::move(graph_); }

 private:
  const MapSnapshot& map_;
  std::unordered_map<KeyframeId, int> index_;
  PoseGraph graph_;
};

}  // namespace

std::optional<std::vector<KeyframeMove>> bendMap(const LoopGeometry& loop,
                                                 const MapSnapshot& map,
                                                 const KeyframeGraph& graph,
                                                 const std::atomic<bool>* cancel) {
  GraphBuilder builder(map);
  for (const KeyframeLink& link : graph.essentialLinks(kMinLinkWeight)) {
    builder.addLink(link.older, link.newer);
  }
  for (const LoopEdge& edge : map.loops()) builder.addLink(edge.older, edge.newer);
  builder.addMeasured(loop.newer, loop.older, loop.S_newer_older);

  const PoseGraph before = builder.take();
  PoseGraph after = before;
  PoseGraphOptions options;
  options.cancel = cancel;
  const PoseGraphSummary summary = solvePoseGraph(options, &after);
  if (!summary.usable || summary.cancelled) return std::nullopt;
  std::vector<KeyframeId> ids;
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) ids.push_back(keyframe.id);
  return keyframeMoves(ids, before, after);
}

}  // namespace glide
