#include "synthetic/living_room/surface_tree.h"

#include "synthetic/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace glide::synthetic {

namespace {

constexpr int kLeafSize = 3;
constexpr float kClearance = 2e-4F;  // metres: a ray does not meet where it starts or ends
constexpr float kThickness = 1e-4F;  // metres: boxes of flat things have a volume
constexpr int kMaxDepth = 64;

Vec3f middleOf(const Surface& surface) {
  return surface.origin + 0.5F * surface.width * surface.axis_u +
         0.5F * surface.height * surface.axis_v;
}

}  // namespace

SurfaceTree::SurfaceTree(std::span<const Surface> surfaces, std::vector<int> indices)
    : surfaces_(surfaces), indices_(std::move(indices)) {
  build(0, static_cast<int>(indices_.size()));
}

SurfaceTree::Node SurfaceTree::boundsOf(int first, int count) const {
  constexpr float kFar = std::numeric_limits<float>::max();
  Node node{Vec3f::Constant(kFar), Vec3f::Constant(-kFar), first, count, 0};
  for (int i = first; i < first + count; ++i) {
    const int index = indices_[static_cast<std::size_t>(i)];
    const Surface& surface = surfaces_[static_cast<std::size_t>(index)];
    const Vec3f u = surface.width * surface.axis_u, v = surface.height * surface.axis_v;
    for (const Vec3f& corner : {surface.origin,
                                Vec3f(surface.origin + u),
                                Vec3f(surface.origin + v),
                                Vec3f(surface.origin + u + v)}) {
      node.low = node.low.cwiseMin(corner - Vec3f::Constant(kThickness));
      node.high = node.high.cwiseMax(corner + Vec3f::Constant(kThickness));
    }
  }
  return node;
}

int SurfaceTree::build(int first, int count) {
  const int self = static_cast<int>(nodes_.size());
  nodes_.push_back(boundsOf(first, count));
  if (count <= kLeafSize) return self;
  int axis = 0;
  (nodes_.back().high - nodes_.back().low).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(indices_.begin() + first,
                   indices_.begin() + first + half,
                   indices_.begin() + first + count,
                   [&](int a, int b) {
                     return middleOf(surfaces_[static_cast<std::size_t>(a)])[axis] <
                            middleOf(surfaces_[static_cast<std::size_t>(b)])[axis];
                   });
  build(first, half);
  const int right = build(first + half, count - half);
  nodes_[static_cast<std::size_t>(self)].right = right;
  nodes_[static_cast<std::size_t>(self)].count = 0;
  return self;
}

bool SurfaceTree::meetsBox(const Node& node, const Ray& ray, float limit) const {
  const Vec3f a = (node.low - ray.from).cwiseProduct(ray.inverse);
  const Vec3f b = (node.high - ray.from).cwiseProduct(ray.inverse);
  const float enter = a.cwiseMin(b).maxCoeff(), leave = a.cwiseMax(b).minCoeff();
  return leave >= std::max(0.0F, enter) && enter < limit;
}

void SurfaceTree::meetSurface(int index, const Ray& ray, float limit, Meeting* nearest) const {
  const Surface& surface = surfaces_[static_cast<std::size_t>(index)];
  const float slope = surface.normal.dot(ray.direction);
  if (slope == 0.0F) return;
  const float range = surface.normal.dot(surface.origin - ray.from) / slope;
  if (range < ray.least || range >= (nearest->index >= 0 ? nearest->range : limit)) return;
  const Vec3f hit = ray.from + range * ray.direction - surface.origin;
  const float u = hit.dot(surface.axis_u), v = hit.dot(surface.axis_v);
  if (u < 0.0F || v < 0.0F || u > surface.width || v > surface.height) return;
  if (surface.is_round && !isInEllipse(surface, u, v)) return;
  *nearest = {index, range, u, v, slope > 0.0F};
}

Meeting SurfaceTree::trace(const Ray& ray, float limit, Search search) const {
  Meeting nearest;
  std::array<int, kMaxDepth> waiting{};
  int count = 1;  // the root
  while (count > 0) {
    const int self = waiting[static_cast<std::size_t>(--count)];
    const Node& node = nodes_[static_cast<std::size_t>(self)];
    if (!meetsBox(node, ray, nearest.index >= 0 ? nearest.range : limit)) continue;
    if (node.right == 0) {
      for (int i = node.first; i < node.first + node.count; ++i)
        meetSurface(indices_[static_cast<std::size_t>(i)], ray, limit, &nearest);
      if (search == Search::any && nearest.index >= 0) return nearest;
    } else {
      waiting[static_cast<std::size_t>(count++)] = node.right;
      waiting[static_cast<std::size_t>(count++)] = self + 1;
    }
  }
  return nearest;
}

Meeting SurfaceTree::nearest(const Vec3f& from, const Vec3f& direction) const {
  return trace({from, direction, direction.cwiseInverse(), kClearance / direction.norm()},
               std::numeric_limits<float>::max(),
               Search::nearest);
}

bool SurfaceTree::isBlocked(const Vec3f& from, const Vec3f& to) const {
  const Vec3f way = to - from;
  const float least = kClearance / way.norm();
  return trace({from, way, way.cwiseInverse(), least}, 1.0F - least, Search::any).index >= 0;
}

}  // namespace glide::synthetic
