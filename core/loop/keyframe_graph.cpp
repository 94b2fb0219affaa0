#include "loop/keyframe_graph.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>

namespace glide {
namespace {

/// Which part of a graph a keyframe belongs to, while links are added.
class Parts {
 public:
  /// False when both belonged together already.
  bool unite(KeyframeId a, KeyframeId b) {
    const KeyframeId root_a = rootOf(a), root_b = rootOf(b);
    if (root_a == root_b) return false;
    parent_[root_b] = root_a;
    return true;
  }

 private:
  std::map<KeyframeId, KeyframeId> parent_;

  KeyframeId rootOf(KeyframeId id) {
    KeyframeId& parent = parent_.try_emplace(id, id).first->second;
    if (parent != id) parent = rootOf(parent);
    return parent;
  }
};

bool isBefore(const KeyframeLink& a, const KeyframeLink& b) {
  return a.older != b.older ? a.older < b.older : a.newer < b.newer;
}

Vec3d centerOf(const SE3d& T_cam_world) { return T_cam_world.inverse().t; }

}  // namespace

KeyframeGraph::KeyframeGraph(const MapSnapshot& map) : map_(&map) {
  // A neighbour's list may lack the way back: each lists what is strong to itself.
  std::map<std::pair<KeyframeId, KeyframeId>, int> weights;
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
    for (const CovisibleKeyframe& neighbor : keyframe.neighbors) {
      if (map.keyframe(neighbor.id) == nullptr) continue;
      weights[std::minmax(keyframe.id, neighbor.id)] = neighbor.weight;
    }
  }
  for (const auto& [pair, weight] : weights) links_.push_back({pair.first, pair.second, weight});
  join();
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) neighbors_[keyframe.id];
  for (const KeyframeLink& link : links_) {
    neighbors_[link.older].emplace_back(link.newer, link.weight);
    neighbors_[link.newer].emplace_back(link.older, link.weight);
  }
}

void KeyframeGraph::join() {
  Parts parts;
  for (const KeyframeLink& link : links_) parts.unite(link.older, link.newer);
  const std::vector<MapSnapshot::KeyframeEntry>& keyframes = map_->keyframes();
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    const KeyframeId older = keyframes[i - 1].id, newer = keyframes[i].id;
    if (parts.unite(older, newer)) links_.push_back({older, newer, 0});
  }
  std::sort(links_.begin(), links_.end(), isBefore);
}

const std::vector<std::pair<KeyframeId, int>>& KeyframeGraph::neighborsOf(KeyframeId id) const {
  return neighbors_.at(id);
}

std::set<KeyframeId> KeyframeGraph::within(KeyframeId id, int steps) const {
  std::set<KeyframeId> found{id};
  std::vector<KeyframeId> rim;
  if (map_->keyframe(id) != nullptr) rim.push_back(id);
  for (int step = 0; step < steps; ++step) {
    std::vector<KeyframeId> next;
    for (const KeyframeId from : rim) {
      for (const auto& [to, weight] : neighborsOf(from)) {
        if (weight > 0 && found.insert(to).second) next.push_back(to);
      }
    }
    rim = std::move(next);
  }
  return found;
}

double KeyframeGraph::pathLength(KeyframeId from, KeyframeId to) const {
  using Reached = std::pair<double, KeyframeId>;  // length so far
  constexpr double kUnreached = std::numeric_limits<double>::infinity();
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> open;
  std::map<KeyframeId, double> shortest;
  if (map_->keyframe(from) == nullptr || map_->keyframe(to) == nullptr) return kUnreached;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [length, id] = open.top();
    open.pop();
    if (id == to) return length;
    if (!shortest.try_emplace(id, length).second) continue;
    const Vec3d center_world = centerOf(map_->keyframe(id)->T_cam_world);
    for (const auto& [next, weight] : neighborsOf(id)) {
      if (shortest.count(next) > 0) continue;
      const Vec3d next_world = centerOf(map_->keyframe(next)->T_cam_world);
      open.emplace(length + (next_world - center_world).norm(), next);
    }
  }
  return kUnreached;
}

std::vector<KeyframeLink> KeyframeGraph::essentialLinks(int min_weight) const {
  std::vector<KeyframeLink> by_weight = links_;
  std::stable_sort(by_weight.begin(), by_weight.end(), [](const auto& a, const auto& b) {
    return a.weight > b.weight;
  });
  std::vector<KeyframeLink> chosen;
  Parts tree;
  for (const KeyframeLink& link : by_weight) {
    const bool is_tree = tree.unite(link.older, link.newer);
    if (is_tree || link.weight >= min_weight) chosen.push_back(link);
  }
  std::sort(chosen.begin(), chosen.end(), isBefore);
  return chosen;
}

std::vector<KeyframeId> placeOf(const MapSnapshot::KeyframeEntry& keyframe, std::size_t count) {
  std::vector<KeyframeId> ids{keyframe.id};
  for (const CovisibleKeyframe& neighbor : keyframe.neighbors) {
    if (ids.size() >= count) break;
    ids.push_back(neighbor.id);
  }
  return ids;
}

}  // namespace glide
