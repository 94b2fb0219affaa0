#pragma once

#include "synthetic/materials.h"
#include "synthetic/texture.h"
#include "synthetic/way.h"

#include "geometry/eigen_types.h"

#include <cstdint>
#include <vector>

namespace glide::synthetic {

enum class SceneKind {
  room,      ///< furnished room, about 1.5 m from the camera
  facade,    ///< street front with things before it, about 6 m from the camera
  desk,      ///< table top, exactly planar, about 0.9 m from the camera
  corridor,  ///< corridor around a block of rooms, 60 to 200 m once around
  hall,      ///< store with shelves, 60 to 200 m once around along its walls
  arcade,    ///< street front of 30 to 60 m whose bays are alike; odd seeds repeat the masonry, too
  living_room,  ///< 5 m room in colour with daylight and lamps; to be walked around
                ///< (MotionKind::orbit)
};

/// A rectangle in the world (x right, y down, z forward, metres), visible from the side of its
/// normal.
struct Surface {
  Vec3f origin = Vec3f::Zero();  ///< corner at texture coordinate (0, 0)
  Vec3f axis_u = Vec3f::UnitX(),
        axis_v = Vec3f::UnitY();      ///< unit, along the texture's rows and columns
  Vec3f normal = -Vec3f::UnitZ();     ///< axis_v x axis_u: towards who sees the texture upright
  float width = 1.0F, height = 1.0F;  ///< along axis_u and axis_v
  Material material = Material::wall;
  float texels_per_m = 1.0F;
  int pattern = kUnique;  ///< surfaces of the same size, material and pattern are painted alike
  Texture texture;        ///< radiance, lit
  bool is_round = false;  ///< only the ellipse that fills the rectangle is there

  static constexpr int kUnique = -1;
};

/// How a camera looks at the scene: the motions are relative to it.
struct Viewpoint {
  Vec3d eye = Vec3d::Zero(), target = Vec3d::UnitZ();
  double depth = 1.5;  ///< typical distance of what is seen, metres; scales the motions
  Vec3d orbit_center = Vec3d::Zero();            ///< what the orbit motion turns around
  double orbit_radius = 1.0, orbit_arc = 6.283;  ///< metres, radians
  double orbit_rise = 0.35;                      ///< height over the centre, share of the radius
  Way way = {};  ///< what the walk motion follows; empty where there is none
};

/// Textured rectangles under fixed lamps. Immutable once made; safe to share between threads.
struct Scene {
  std::vector<Surface> surfaces;
  Viewpoint viewpoint;
  bool has_color = false;  ///< all textures are in colour; else all are gray
};

/// The same kind and seed make the same scene, bit for bit.
Scene makeScene(SceneKind kind, std::uint64_t seed);

}  // namespace glide::synthetic
