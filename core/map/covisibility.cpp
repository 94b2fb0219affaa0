#include "map/covisibility.h"

#include <algorithm>
#include <cassert>

namespace glide {
namespace {

bool isBetter(const CovisibleKeyframe& a, const CovisibleKeyframe& b) {
  return a.weight != b.weight ? a.weight > b.weight : a.id < b.id;
}

}  // namespace

void Covisibility::change(KeyframeId a, KeyframeId b, int delta) {
  assert(a != b);
  changeDirected(a, b, delta);
  changeDirected(b, a, delta);
}

void Covisibility::changeDirected(KeyframeId from, KeyframeId to, int delta) {
  auto& edges = edges_[from];
  int& weight = edges[to];
  weight += delta;
  assert(weight >= 0);
  if (weight > 0) return;
  edges.erase(to);
  if (edges.empty()) edges_.erase(from);
}

int Covisibility::weight(KeyframeId a, KeyframeId b) const {
  const auto found = edges_.find(a);
  if (found == edges_.end()) return 0;
  const auto edge = found->second.find(b);
  return edge != found->second.end() ? edge->second : 0;
}

std::vector<CovisibleKeyframe> Covisibility::neighbors(KeyframeId id, int min_weight) const {
  const auto found = edges_.find(id);
  if (found == edges_.end()) return {};
  std::vector<CovisibleKeyframe> result;
  CovisibleKeyframe best;
  for (const auto& [other, weight] : found->second) {
    const CovisibleKeyframe edge{other, weight};
    if (weight >= min_weight) result.push_back(edge);
    if (best.weight == 0 || isBetter(edge, best)) best = edge;
  }
  if (result.empty()) result.push_back(best);
  std::sort(result.begin(), result.end(), isBetter);
  return result;
}

}  // namespace glide
