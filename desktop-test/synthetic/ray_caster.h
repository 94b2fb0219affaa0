#pragma once

#include "synthetic/scene.h"

#include "geometry/eigen_types.h"

#include <vector>

namespace glide::synthetic {

/// Whether a point of the surface's rectangle (metres) lies in the ellipse that fills it.
bool isInEllipse(const Surface& surface, float u, float v);

/// Where a ray meets a surface.
struct Hit {
  int index = -1;      ///< of the surface, in the order of add(); -1 = nothing
  float range = 0.0F;  ///< in lengths of the ray's direction
};

/// A few surfaces, prepared for rays from one centre. The surfaces must outlive it.
class RayCaster {
 public:
  void clear() { targets_.clear(); }
  void add(const Surface& surface) { targets_.push_back({&surface, 0.0F, 0.0F, 0.0F}); }
  /// Sets where the following rays start, in the world.
  void moveTo(const Vec3f& center_world);

  /// The nearest surface along a direction, both in the world; a surface is invisible from behind.
  Hit trace(const Vec3f& d_world) const;
  /// Radiance at a hit, averaged over the cone of one pixel (radians): float in a gray scene, Vec3f
  /// in one with colours.
  template <class Value>
  Value shade(const Hit& hit, const Vec3f& d_world, float pixel_angle) const;

 private:
  struct Target {
    const Surface* surface;
    float height;  ///< of the centre over the plane, metres
    float u, v;    ///< of the centre's foot point, metres
  };
  std::vector<Target> targets_;
};

}  // namespace glide::synthetic
