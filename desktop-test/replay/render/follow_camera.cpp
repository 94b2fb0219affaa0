#include "replay/render/follow_camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glide::replay {
namespace {

// Seconds until a difference has shrunk to a third.
constexpr double kFocusLag = 0.8, kHeadingLag = 2.5, kUpLag = 3.0;
constexpr double kRetreatLag = 0.35, kApproachLag = 1.5;  // what is new is to be seen at once
constexpr double kMaxStep = 1.0;  // s; a gap in the frames is no reason to jump
constexpr double kTwoPi = 6.283185307179586;
constexpr double kSwing = 0.6, kSwingPeriod = 16.0;  // radians and seconds: parallax without haste
constexpr double kShown = 0.9;           // share of the landmarks that must be in the picture
constexpr double kMargin = 1.15;         // frusta are larger than the points where they stand
constexpr double kLeastDistance = 1e-3;  // scene units: of a map that is a single point
constexpr double kElevation = 0.6;       // radians: the path is seen, and walls, too

double gain(double step_s, double lag_s) { return 1.0 - std::exp(-step_s / lag_s); }

Vec3d turned(const Vec3d& from, const Vec3d& to, double share) {
  constexpr double kOpposite = 1e-3;  // norm of the middle of two unit vectors
  const Vec3d mixed = from + share * (to - from);
  return mixed.norm() < kOpposite ? from
                                  : mixed.normalized();  // opposite: stay until one side wins
}

}  // namespace

void FollowCamera::follow(const Framing& framing, double t_s) {
  const double step_s = std::clamp(t_s - t_s_, 0.0, kMaxStep);
  t_s_ = t_s;
  if (shown_) {
    approach(framing, step_s);
    return;
  }
  swing_s_ = 0.0;
  shown_.emplace();
  shown_->focus = framing.focus;
  shown_->up = framing.up;
  shown_->ahead = levelPart(framing.ahead, framing.up, framing.up.unitOrthogonal());
  shown_->elevation = kElevation;
  shown_->distance = distanceFor(framing);
}

void FollowCamera::approach(const Framing& framing, double step_s) {
  Orbit& shown = *shown_;
  shown.focus += gain(step_s, kFocusLag) * (framing.focus - shown.focus);
  shown.up = turned(shown.up, framing.up, gain(step_s, kUpLag));
  const Vec3d level = levelPart(framing.ahead, shown.up, shown.ahead);
  const Vec3d ahead = turned(shown.ahead, level, gain(step_s, kHeadingLag));
  shown.ahead = levelPart(ahead, shown.up, shown.up.unitOrthogonal());
  swing_s_ += step_s;
  shown.azimuth = kSwing * std::sin(kTwoPi * swing_s_ / kSwingPeriod);
  const double wanted = distanceFor(framing);
  const double lag_s = wanted > shown.distance ? kRetreatLag : kApproachLag;
  shown.distance *= std::pow(wanted / shown.distance, gain(step_s, lag_s));
}

double FollowCamera::distanceFor(const Framing& framing) const {
  std::vector<double> distances;
  distances.reserve(framing.landmarks.size());
  for (const Vec3d& p : framing.landmarks) {
    distances.push_back(distanceToSee(p, *shown_, field_of_view_));
  }
  const auto last = distances.begin() +
                    static_cast<std::ptrdiff_t>(kShown * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), last, distances.end());
  double distance = *last;
  for (const Vec3d& p : framing.cameras) {
    distance = std::max(distance, distanceToSee(p, *shown_, field_of_view_));
  }
  return std::max(kMargin * distance, kLeastDistance);
}

}  // namespace glide::replay
