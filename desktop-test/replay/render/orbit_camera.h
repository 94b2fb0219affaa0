#pragma once

#include "geometry/eigen_types.h"

#include "glide/render_types.h"

namespace glide::replay {

/// A camera on a sphere around a point. All vectors in the map's world (OpenCV axes), angles in
/// radians.
struct Orbit {
  Vec3d focus = Vec3d::Zero();  ///< what is looked at
  Vec3d up{0.0, -1.0, 0.0};     ///< unit
  Vec3d ahead{0.0, 0.0, 1.0};   ///< unit, level: where it looks at azimuth, elevation 0
  double azimuth = 0.0;         ///< to the left around `up`
  double elevation = 0.0;       ///< how high the camera stands, below a right angle
  double distance = 1.0;        ///< from the focus, positive
};

/// What a perspective picture of width / height = `aspect` shows.
struct Lens {
  double field_of_view = 0.87;  ///< radians, of the shorter side
  double aspect = 1.0;
};

/// Where the camera stands.
Vec3d eyeOf(const Orbit& orbit);

/// The distance of the orbit from which a point lies on the edge of the square in the middle of the
/// picture; `orbit.distance` does not matter.
double distanceToSee(const Vec3d& p_world, const Orbit& orbit, double field_of_view);

/// For the renderer; everything from a hundredth of the orbit's distance to a hundred times it is
/// seen.
ViewCamera viewOf(const Orbit& orbit, const Lens& lens);

/// The part of `direction` that is level when `up` is up, as a unit vector; `otherwise` when the
/// direction is too steep to have one.
Vec3d levelPart(const Vec3d& direction, const Vec3d& up, const Vec3d& otherwise);

}  // namespace glide::replay
