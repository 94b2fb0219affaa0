#pragma once

#include "synthetic/lighting.h"
#include "synthetic/scene.h"

namespace glide::synthetic {

/// A box that stands upright, possibly turned about the vertical.
struct Box {
  Vec3f center = Vec3f::Zero();
  Vec3f size = Vec3f::Ones();  ///< width (x), height (y), depth (z) before turning
  float yaw = 0.0F;            ///< radians
  Material front = Material::wood, side = Material::wood, top = Material::wood;
  int pattern = Surface::kUnique;  ///< boxes of the same pattern and size are alike
};

/// Adds the five faces that can be seen (all but the bottom).
void addBox(const Box& box, float texels_per_m, Scene* scene);

/// Adds the six faces of a box seen from inside: front and back are the walls of +z and -z.
struct Interior {
  Vec3f low, high;
  Material wall, floor, ceiling;
};
void addInterior(const Interior& interior, float texels_per_m, Scene* scene);

/// A rectangle with corner `origin`, spanned by `along_u` and `along_v` (perpendicular).
void addSurface(
    const Vec3f& origin, const Vec3f& along_u, const Vec3f& along_v, Surface look, Scene* scene);

/// Four legs and a top.
struct Table {
  Vec3f top_center;
  Vec3f size;  ///< width, height down to the floor, depth
  float yaw = 0.0F;
};
void addTable(const Table& table, float texels_per_m, Scene* scene);

/// Paints and lights every surface. The last step: shadows need all surfaces.
void finishScene(const Lighting& lighting, std::uint64_t seed, Scene* scene);

Scene makeRoom(std::uint64_t seed);
Scene makeFacade(std::uint64_t seed);
Scene makeDesk(std::uint64_t seed);
Scene makeCorridor(std::uint64_t seed);
Scene makeHall(std::uint64_t seed);
Scene makeArcade(std::uint64_t seed);
Scene makeLivingRoom(std::uint64_t seed);

}  // namespace glide::synthetic
