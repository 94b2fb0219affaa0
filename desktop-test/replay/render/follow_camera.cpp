#include "replay/render/follow_camera.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

// Seconds until a difference has shrunk to a third: what the camera does, then what it sees.
constexpr double kFocusLag = 0.8, kRadiusLag = 1.5, kHeadingLag = 2.5, kUpLag = 3.0;
constexpr double kMaxStep = 1.0;  // s; a gap in the frames is no reason to jump
constexpr double kTwoPi = 6.283185307179586;
constexpr double kSwing = 0.6, kSwingPeriod = 16.0;  // radians and seconds: parallax without haste
constexpr double kElevation = 0.6;                   // radians: the path is seen, and walls, too

double gain(double step_s, double lag_s) { return 1.0 - std::exp(-step_s / lag_s); }

Vec3d turned(const Vec3d& from, const Vec3d& to, double share) {
  const Vec3d mixed = from + share * (to - from);
  return mixed.norm() < 1e-3 ? from : mixed.normalized();  // opposite: stay until one side wins
}

}  // namespace

void FollowCamera::follow(const Framing& framing, double t_s) {
  const double step_s = std::clamp(t_s - t_s_, 0.0, kMaxStep);
  t_s_ = t_s;
  if (!shown_) {
    shown_ = framing;
    shown_->ahead = levelPart(framing.ahead, framing.up, framing.up.unitOrthogonal());
    return;
  }
  swing_s_ += step_s;
  Framing& shown = *shown_;
  shown.focus += gain(step_s, kFocusLag) * (framing.focus - shown.focus);
  shown.radius *= std::pow(framing.radius / shown.radius, gain(step_s, kRadiusLag));
  shown.up = turned(shown.up, framing.up, gain(step_s, kUpLag));
  const Vec3d level = levelPart(framing.ahead, shown.up, shown.ahead);
  const Vec3d ahead = turned(shown.ahead, level, gain(step_s, kHeadingLag));
  shown.ahead = levelPart(ahead, shown.up, shown.up.unitOrthogonal());
}

std::optional<Orbit> FollowCamera::orbit(const Lens& lens) const {
  if (!shown_) return std::nullopt;
  Orbit orbit;
  orbit.focus = shown_->focus;
  orbit.up = shown_->up;
  orbit.ahead = shown_->ahead;
  orbit.azimuth = kSwing * std::sin(kTwoPi * swing_s_ / kSwingPeriod);
  orbit.elevation = kElevation;
  orbit.distance = distanceToSee(shown_->radius, lens);
  return orbit;
}

}  // namespace glide::replay
