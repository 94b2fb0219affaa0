#pragma once

#include "synthetic/living_room/color_canvas.h"
#include "synthetic/living_room/room_light.h"
#include "synthetic/scene.h"

#include <cstdint>
#include <vector>

namespace glide::synthetic {

/// How a surface is painted and shines.
struct Look {
  Painter paint;
  float texels_per_m = 420.0F;
  float glow = 0.0F;      ///< more than 0: shines so many times as bright as it is painted, unlit
  bool is_round = false;  ///< the ellipse in its rectangle
};

/// The looks of a box as seen from its front.
struct BoxLook {
  Look front, side, top;
};
/// The same on all sides.
BoxLook allAround(const Look& look);

/// Where things stand: metres in the world (y down), turned about the vertical by `yaw` (radians;
/// 0: the front looks towards -z).
struct Stand {
  Vec3f foot = Vec3f::Zero();
  float yaw = 0.0F;

  /// A point `right`, `up` and `back` of the foot as seen from the front.
  Vec3f at(float right, float up, float back) const;
  /// The same turn with another foot.
  Stand stand(float right, float up, float back, float turn) const;
};

/// Collects painted surfaces and finishes them to a scene.
class RoomBuilder {
 public:
  /// A rectangle with corner `origin`, spanned by two perpendicular vectors; visible from the side
  /// towards which along_v x along_u points.
  void add(const Vec3f& origin, const Vec3f& along_u, const Vec3f& along_v, const Look& look);
  /// Five faces (not the bottom) of a box whose middle stands on `stand`; size is width, height,
  /// depth.
  void addBox(const Stand& stand, const Vec3f& size, const BoxLook& look);
  /// The same with a bottom like its top, for what hangs or lies above the eyes.
  void addSlab(const Stand& stand, const Vec3f& size, const BoxLook& look);
  /// A bar of square section from one point to another.
  void addBar(const Vec3f& from, const Vec3f& to, float thickness, const Look& look);
  /// A wall of `sides` flat faces around the vertical, and a round lid.
  struct Drum {
    float radius, height;
    int sides;
  };
  void addDrum(const Stand& stand, const Drum& drum, const Look& wall, const Look& lid);
  /// A flat leaf with two sides, from its stalk along its length.
  void addLeaf(const Vec3f& stalk, const Vec3f& along, const Vec3f& across, const Look& look);

  /// Paints and lights everything.
  Scene finish(const RoomLight& light, std::uint64_t seed) const;

 private:
  std::vector<Surface> surfaces_;
  std::vector<Look> looks_;
};

}  // namespace glide::synthetic
