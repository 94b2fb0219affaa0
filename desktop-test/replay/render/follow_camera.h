#pragma once

#include "replay/render/framing.h"
#include "replay/render/orbit_camera.h"

#include <optional>

namespace glide::replay {

/// Turns framings that jump with every map and frame into a calm flight: behind and above the
/// camera, swinging to and fro so that depth shows, as near as what is to be seen allows. Time is
/// the frames' own: the same frames give the same flight.
class FollowCamera {
 public:
  /// For pictures with this angle across their shorter side, radians.
  explicit FollowCamera(double field_of_view) : field_of_view_(field_of_view) {}

  /// The framing that is right at a time, in seconds; times increase. The first is taken as it is.
  void follow(const Framing& framing, double t_s);
  /// The next framing is taken as it is: another map.
  void jump() { shown_.reset(); }

  /// What to draw with; nothing before the first framing.
  const std::optional<Orbit>& orbit() const { return shown_; }

 private:
  void approach(const Framing& framing, double step_s);
  double distanceFor(const Framing& framing) const;

  double field_of_view_;
  std::optional<Orbit> shown_;
  double t_s_ = 0.0;
  double swing_s_ = 0.0;  ///< time spent following
};

}  // namespace glide::replay
