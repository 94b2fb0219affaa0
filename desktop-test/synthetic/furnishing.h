#pragma once

#include "synthetic/random.h"
#include "synthetic/scene_builder.h"

#include <span>

namespace glide::synthetic {

/// A kind of thing that stands or hangs along walls; sizes in metres.
struct Furniture {
  float min_width, max_width, height, depth;
  float above_floor;  ///< metres from the floor to its lower edge
  Material front, side, top;
};

/// A straight wall: its foot's middle on the floor, where it faces, and how long it is.
struct WallRun {
  Vec3f foot = Vec3f::Zero();
  Vec3f normal = -Vec3f::UnitZ();  ///< horizontal, axis-aligned
  float length = 1.0F;             ///< metres
};

/// Metres left free at the ends of a wall and between two things along it.
struct Gaps {
  float ends = 1.0F, least = 0.5F, most = 2.5F;
};

/// Stands furniture of random kinds along a wall, in random order and distances.
void furnish(const WallRun& run,
             std::span<const Furniture> kinds,
             const Gaps& gaps,
             Random* random,
             Scene* scene);

/// The wall itself, upright, as seen from where it faces.
void addWall(const WallRun& run, float height, const Surface& look, Scene* scene);

}  // namespace glide::synthetic
