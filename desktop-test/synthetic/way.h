#pragma once

#include "geometry/eigen_types.h"

#include <vector>

namespace glide::synthetic {

/// Where a walker is and looks, at equal times.
struct Way {
  double step_s = 1.0;
  std::vector<Vec3d> x_z_yaw;  ///< metres, metres, radians about the vertical; yaw 0 looks along z
};

/// Seconds from the first to the last sample; 0 when the way is empty.
double duration(const Way& way);

/// Between the samples with continuous velocity (Catmull-Rom); stands still beyond the ends. The
/// way must not be empty.
Vec3d wayAt(const Way& way, double t_s);

/// How fast one goes and where one looks.
struct Pace {
  double speed = 3.0;      ///< m/s on straight stretches
  double turn_rate = 1.2;  ///< rad/s in bends
  double gaze = 0.0;       ///< radians from the direction of travel, to the right
};

/// A rectangle with round corners about the origin.
struct RoundTrip {
  double half_x = 10.0, half_z = 10.0;  ///< metres to the sides
  double corner_radius = 1.0;           ///< metres
  double overlap = 8.0;                 ///< metres walked again at the end
  bool is_mirrored = false;             ///< bends to the left instead of to the right
};

/// half_x + half_z of the rectangle whose round is `length` metres long.
double halfSizesOfRound(double length, double corner_radius);

Way walkAround(const RoundTrip& trip, const Pace& pace);

/// From (x0, z) to (x1, z).
struct Straight {
  double x0 = 0.0, x1 = 10.0, z = 0.0;  ///< metres
};
Way walkStraight(const Straight& line, const Pace& pace);

}  // namespace glide::synthetic
