#include "synthetic/way.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace glide::synthetic {

namespace {

constexpr double kHalfPi = 1.5707963267948966;
constexpr double kStep = 1.0 / 60.0;  // seconds between samples
constexpr int kSmoothing = 15;        // samples to either side: a quarter of a second

/// A straight line or a bend.
struct Piece {
  double length = 0.0;  ///< metres
  double turn = 0.0;    ///< radians to the right over the whole piece
};

Vec3d advanced(const Vec3d& x_z_yaw, const Piece& piece, double share) {
  const double yaw = x_z_yaw.z(), turn = share * piece.turn, length = share * piece.length;
  // The chord of an arc points along the mean direction and is sinc(turn / 2) times as long.
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
  return {x_z_yaw.x() + chord * std::sin(yaw + half),
          x_z_yaw.y() + chord * std::cos(yaw + half),
          yaw + turn};
}

std::vector<Vec3d> sampled(const Vec3d& start, const std::vector<Piece>& pieces, const Pace& pace) {
  std::vector<Vec3d> samples;
  Vec3d at = start;
  double waiting = 0.0;  // seconds from the piece's start to the next sample
  for (const Piece& piece : pieces) {
    const double seconds =
        std::max(piece.length / pace.speed, std::abs(piece.turn) / pace.turn_rate);
    for (; waiting < seconds; waiting += kStep)
      samples.push_back(advanced(at, piece, waiting / seconds));
    waiting -= seconds;
    at = advanced(at, piece, 1.0);
  }
  return samples;
}

/// Moving average, narrower at the ends: nobody changes speed or direction at once.
std::vector<Vec3d> smoothed(const std::vector<Vec3d>& samples) {
  std::vector<Vec3d> smooth;
  const int count = static_cast<int>(samples.size());
  for (int i = 0; i < count; ++i) {
    const int reach = std::min({kSmoothing, i, count - 1 - i});
    Vec3d sum = Vec3d::Zero();
    for (int k = i - reach; k <= i + reach; ++k) sum += samples[static_cast<std::size_t>(k)];
    smooth.emplace_back(sum / (2 * reach + 1));
  }
  return smooth;
}

Way makeWay(const Vec3d& start, const std::vector<Piece>& pieces, const Pace& pace) {
  Way way;
  way.step_s = kStep;
  way.x_z_yaw = smoothed(smoothed(sampled(start, pieces, pace)));
  for (Vec3d& sample : way.x_z_yaw) sample.z() += pace.gaze;
  return way;
}

}  // namespace

double duration(const Way& way) {
  return way.x_z_yaw.empty() ? 0.0 : way.step_s * static_cast<double>(way.x_z_yaw.size() - 1);
}

Vec3d wayAt(const Way& way, double t_s) {
  const int last = static_cast<int>(way.x_z_yaw.size()) - 1;
  const double position = std::clamp(t_s / way.step_s, 0.0, static_cast<double>(last));
  const int i = std::min(static_cast<int>(position), std::max(last - 1, 0));
  const auto sample = [&](int k) {
    return way.x_z_yaw[static_cast<std::size_t>(std::clamp(k, 0, last))];
  };
  const Vec3d a = sample(i - 1), b = sample(i), c = sample(i + 1), d = sample(i + 2);
  const double x = position - i;
  const Vec3d slope_b = 0.5 * (c - a), slope_c = 0.5 * (d - b);
  const Vec3d quadratic = 3.0 * (c - b) - 2.0 * slope_b - slope_c;
  const Vec3d cubic = slope_b + slope_c - 2.0 * (c - b);
  return b + x * (slope_b + x * (quadratic + x * cubic));
}

double halfSizesOfRound(double length, double corner_radius) {
  return (length + (8.0 - 4.0 * kHalfPi) * corner_radius) / 4.0;
}

Way walkAround(const RoundTrip& trip, const Pace& pace) {
  const double r = trip.corner_radius;
  const double side_x = 2.0 * (trip.half_x - r), side_z = 2.0 * (trip.half_z - r);
  const double first = 0.5 * side_z;  // the walk begins in the middle of the side at -x
  const Piece bend{kHalfPi * r, kHalfPi};
  const std::vector<Piece> pieces{{first, 0.0},
                                  bend,
                                  {side_x, 0.0},
                                  bend,
                                  {side_z, 0.0},
                                  bend,
                                  {side_x, 0.0},
                                  bend,
                                  {side_z - first + trip.overlap, 0.0}};
  Way way = makeWay({-trip.half_x, 0.0, 0.0}, pieces, pace);
  if (trip.is_mirrored) {
    for (Vec3d& sample : way.x_z_yaw) sample = {-sample.x(), sample.y(), -sample.z()};
  }
  return way;
}

Way walkStraight(const Straight& line, const Pace& pace) {
  const double length = std::abs(line.x1 - line.x0);
  return makeWay({line.x0, line.z, line.x1 > line.x0 ? kHalfPi : -kHalfPi}, {{length, 0.0}}, pace);
}

}  // namespace glide::synthetic
