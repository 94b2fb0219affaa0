#pragma once

#include "geometry/eigen_types.h"

#include "glide/render_types.h"

#include <array>
#include <vector>

namespace glide {

/// A face of the AR cube, in units of its edge and in the axes of ArContent::cubes: the origin is
/// the centre of the bottom face, y points down.
struct CubeFace {
  Vec3d center, normal, right, down;

  /// Point at (s, t), from (0, 0), a corner, to (1, 1), the opposite one.
  Vec3d at(double s, double t) const { return center + (s - 0.5) * right + (t - 0.5) * down; }
};
std::array<CubeFace, 6> cubeFaces();

/// An edge, and which two faces meet there.
struct CubeEdge {
  Vec3d from, to;
  std::array<std::size_t, 2> faces{};
};
std::vector<CubeEdge> cubeEdges();

/// Colour of a point of a face: lit from above and the side, darker towards the ground.
Color cubeColor(const Vec3d& point, const Vec3d& normal);

/// How far beyond the cube its shadow on the ground ends, in units of the edge.
inline constexpr double kShadowReach = 0.45;
/// How dark the ground is at (x, z) in units of the edge, 0 to 1: soft.
double cubeShadow(double x, double z);

}  // namespace glide
