#include "replay/render/view_control.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr double kTurnPerPx = 0.006;  // radians: half a turn over some 500 px
constexpr double kZoomStep = 1.15;
constexpr double kNearest = 0.05, kFarthest = 20.0;  // of the flight's distance
constexpr double kSteepest = 1.5;  // radians: straight up and down have no "ahead"

}  // namespace

void ViewControl::drag(double x_px, double y_px) {
  azimuth_ -= kTurnPerPx * x_px;  // the scene goes along with the pointer
  elevation_ += kTurnPerPx * y_px;
}

void ViewControl::zoom(double steps) {
  nearness_ = std::clamp(nearness_ / std::pow(kZoomStep, steps), kNearest, kFarthest);
}

void ViewControl::toggleFollow(const Orbit& shown) {
  is_following_ = !is_following_;
  held_ = shown;
  azimuth_ = elevation_ = 0.0;
  nearness_ = 1.0;
}

Orbit ViewControl::apply(const Orbit& flight) const {
  Orbit orbit = is_following_ ? flight : held_;
  orbit.azimuth += azimuth_;
  orbit.elevation = std::clamp(orbit.elevation + elevation_, -kSteepest, kSteepest);
  orbit.distance *= nearness_;
  return orbit;
}

}  // namespace glide::replay
