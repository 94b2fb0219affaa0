#include "render/camera_cube.h"

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

constexpr Color kCube{0.247F, 0.757F, 0.788F, 1.0F};  // teal: no colour of the map's
// The parts of the light: from everywhere, and from a lamp above, left and in front.
constexpr double kAmbient = 0.55, kLamp = 0.5;
const Vec3d kToLamp = Vec3d(-0.35, -0.85, -0.4).normalized();
// What is left of the light at the ground, where the cube stands in its own way.
constexpr double kLightAtGround = 0.72;
constexpr double kDarkest = 0.6;  // of the shadow

Vec3d axis(int index) { return Vec3d::Unit(index); }

CubeFace face(int index) {
  const double sign = index % 2 == 0 ? -1.0 : 1.0;
  const int along = index / 2;
  const Vec3d normal = sign * axis(along);
  return {
      Vec3d(0.0, -0.5, 0.0) + 0.5 * normal, normal, axis((along + 1) % 3), axis((along + 2) % 3)};
}

}  // namespace

std::array<CubeFace, 6> cubeFaces() {
  return {face(0), face(1), face(2), face(3), face(4), face(5)};
}

std::vector<CubeEdge> cubeEdges() {
  const std::array<CubeFace, 6> faces = cubeFaces();
  std::vector<CubeEdge> edges;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      const Vec3d along = faces[i].normal.cross(faces[j].normal);
      if (along.isZero()) continue;  // opposite faces
      const Vec3d middle = faces[i].center + 0.5 * faces[j].normal;
      edges.push_back({middle - 0.5 * along, middle + 0.5 * along, {i, j}});
    }
  }
  return edges;
}

Color cubeColor(const Vec3d& point, const Vec3d& normal) {
  const double height = std::clamp(-point.y(), 0.0, 1.0);
  const double open = kLightAtGround + (1.0 - kLightAtGround) * height;
  const double light = open * (kAmbient + kLamp * std::max(0.0, normal.dot(kToLamp)));
  Color color = kCube;
  for (std::size_t i = 0; i < 3; ++i)
    color[i] = std::min(1.0F, color[i] * static_cast<float>(light));
  return color;
}

double cubeShadow(double x, double z) {
  const double outside =
      std::hypot(std::max(0.0, std::abs(x) - 0.5), std::max(0.0, std::abs(z) - 0.5));
  const double share = std::max(0.0, 1.0 - outside / kShadowReach);
  return kDarkest * share * share;
}

}  // namespace glide
