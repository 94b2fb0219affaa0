#pragma once

#include "replay/render/orbit_camera.h"

namespace glide::replay {

/// What a person adds to the flight of the 3-D view: turns it and goes nearer while it follows the
/// camera, or holds it in place.
class ViewControl {
 public:
  /// The pointer moved with the button down, px; to the right and down are positive.
  void drag(double x_px, double y_px);
  /// Turns of a wheel; positive: nearer.
  void zoom(double steps);
  /// Holds the view where it is, or follows again. `shown`: what is seen now.
  void toggleFollow(const Orbit& shown);

  bool isFollowing() const { return is_following_; }
  /// What to draw with when the flight wants `flight`.
  Orbit apply(const Orbit& flight) const;

 private:
  bool is_following_ = true;
  Orbit held_;  ///< while not following
  double azimuth_ = 0.0, elevation_ = 0.0, nearness_ = 1.0;
};

}  // namespace glide::replay
