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
  std::vector<CovisibleKeyframe>& edges = edges_[from];
  auto edge = std::find_if(
      edges.begin(), edges.end(), [to](const CovisibleKeyframe& e) { return e.id == to; });
  if (edge == edges.end()) edge = edges.insert(edge, {to, 0});
  edge->weight += delta;
  assert(edge->weight >= 0);
  if (edge->weight > 0) return;
  *edge = edges.back();
  edges.pop_back();
  if (edges.empty()) edges_.erase(from);
}

int Covisibility::weight(KeyframeId a, KeyframeId b) const {
  const auto found = edges_.find(a);
  if (found == edges_.end()) return 0;
  for (const CovisibleKeyframe& edge : found->second) {
    if (edge.id == b) return edge.weight;
  }
  return 0;
}

std::vector<CovisibleKeyframe> Covisibility::neighbors(KeyframeId id, int min_weight) const {
  const auto found = edges_.find(id);
  if (found == edges_.end()) return {};
  std::vector<CovisibleKeyframe> result;
  for (const CovisibleKeyframe& edge : found->second) {
    if (edge.weight >= min_weight) result.push_back(edge);
  }
  if (result.empty()) {
    result.push_back(*std::min_element(found->second.begin(), found->second.end(), isBetter));
  }
  std::sort(result.begin(), result.end(), isBetter);
  return result;
}

}  // namespace glide
