#pragma once

#include "synthetic/scene.h"

#include <span>
#include <vector>

namespace glide::synthetic {

/// Where a ray meets a surface, from whichever side.
struct Meeting {
  int index = -1;               ///< of the surface; -1 = nothing
  float range = 0.0F;           ///< in lengths of the ray's direction
  float u = 0.0F, v = 0.0F;     ///< metres along the surface's axes
  bool is_from_behind = false;  ///< the side that no camera sees
};

/// Finds what a ray meets among many surfaces: a hierarchy of boxes, split at the middle surface
/// along the longest axis. The surfaces must outlive it and stay as they are.
class SurfaceTree {
 public:
  /// Of the surfaces with these indices.
  SurfaceTree(std::span<const Surface> surfaces, std::vector<int> indices);

  Meeting nearest(const Vec3f& from, const Vec3f& direction) const;
  /// Whether something stands between two points.
  bool isBlocked(const Vec3f& from, const Vec3f& to) const;

 private:
  struct Node {
    Vec3f low, high;
    int first = 0, count = 0;  ///< of indices_, when it is a leaf
    int right = 0;             ///< the left child is the next node
  };
  struct Ray {
    Vec3f from, direction, inverse;
    float least;  ///< range of what it can meet
  };

  int build(int first, int count);
  Node boundsOf(int first, int count) const;
  bool meetsBox(const Node& node, const Ray& ray, float limit) const;
  void meetSurface(int index, const Ray& ray, float limit, Meeting* nearest) const;
  enum class Search { nearest, any };
  Meeting trace(const Ray& ray, float limit, Search search) const;

  std::span<const Surface> surfaces_;
  std::vector<int> indices_;
  std::vector<Node> nodes_;
};

}  // namespace glide::synthetic
