#pragma once

#include "synthetic/living_room/surface_tree.h"
#include "synthetic/scene.h"
#include "synthetic/texture.h"

#include <span>
#include <vector>

namespace glide::synthetic {

/// An opening through which the sky shines in. Irradiances here and below are linear, 1 = white
/// paper is white.
struct Opening {
  Vec3f corner, along_u, along_v;  ///< metres
  Vec3f radiance;                  ///< of the sky
};

/// A lamp that shines to all sides, of the size of its shade.
struct Bulb {
  Vec3f center;
  float radius = 0.1F;  ///< metres: softness of the shadows
  Vec3f power;          ///< irradiance at one metre under normal incidence
};

struct RoomLight {
  Vec3f to_sun = -Vec3f::UnitY();  ///< unit
  Vec3f sun;                       ///< irradiance under normal incidence
  std::vector<Opening> openings;
  std::vector<Bulb> bulbs;
};

/// What light sees of a surface.
struct Reflector {
  Vec3f albedo = Vec3f::Zero();  ///< linear, averaged over the surface
  bool is_shining = false;       ///< a lamp's shade, the view out of a window: not lit, no shadow
};

/// Irradiance over a surface.
class LightGrid {
 public:
  LightGrid(const Surface& surface, float spacing_m);

  const ImageRgb& nodes() const { return nodes_; }
  ImageRgb& nodes() { return nodes_; }
  /// Metres along the surface's axes where node (x, y) is; a hair inside of the outline.
  Vec2f placeOf(int x, int y) const;
  /// Between the nodes, bilinear.
  Vec3f at(float u, float v) const;

 private:
  Vec2f size_, spacing_;  ///< metres
  ImageRgb nodes_;
};

/// Light of the sun, the sky and the lamps with soft shadows, and what the surfaces pass on to each
/// other: two bounces, gathered over the half space (Cohen and Wallace, Radiosity and Realistic
/// Image Synthesis, 1993).
class LitRoom {
 public:
  LitRoom(std::span<const Surface> surfaces,
          std::vector<Reflector> reflectors,
          const RoomLight& light);

  /// Irradiance at a place of a surface, metres along its axes.
  Vec3f at(std::size_t surface, float u, float v) const;

 private:
  Vec3f direct(const Vec3f& p, const Vec3f& normal) const;
  Vec3f fromSun(const Vec3f& p, const Vec3f& normal) const;
  Vec3f fromOpening(const Opening& opening, const Vec3f& p, const Vec3f& normal) const;
  Vec3f fromBulb(const Bulb& bulb, const Vec3f& p, const Vec3f& normal) const;
  Vec3f gathered(const Vec3f& p, const Vec3f& normal) const;
  template <class Light>
  void fillGrids(std::vector<LightGrid>* grids, const Light& light) const;

  std::span<const Surface> surfaces_;
  const std::vector<Reflector> reflectors_;
  const RoomLight light_;
  const SurfaceTree tree_;
  std::vector<LightGrid> direct_, bounced_;  ///< per surface
};

}  // namespace glide::synthetic
