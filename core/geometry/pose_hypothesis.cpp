#include "geometry/pose_hypothesis.h"

#include "geometry/essential.h"
#include "geometry/robust.h"
#include "geometry/triangulate.h"

#include <cmath>

namespace glide {
namespace {

/// Noise of the angle between two rays is sqrt(2) sigma: three times that tells front from behind.
constexpr double kParallaxSigmas = 4.2;

PoseHypothesis assess(const SE3d& T_b_a, std::span<const RayPair> pairs, double sigma_px) {
  const Mat3d E = essentialOf(T_b_a);
  const double inverse_variance = 1.0 / (sigma_px * sigma_px);
  PoseHypothesis out;
  out.T_b_a = T_b_a;
  for (const RayPair& pair : pairs) {
    const double margin = kChi2_1 - sampsonSquared(E, pair) * inverse_variance;
    if (!(margin > 0.0)) continue;
    ++out.inliers;
    const bool far = !hasParallax(T_b_a.q, pair, sigma_px);
    const bool in_front = far || triangulate(T_b_a, pair.a.f, pair.b.f).has_value();
    if (in_front) out.score += margin;
    out.front += !far && in_front ? 1 : 0;
    out.behind += !far && !in_front ? 1 : 0;
  }
  return out;
}

}  // namespace

double rayParallax(const Eigen::Quaterniond& q_b_a, const RayPair& pair) {
  const Vec3d turned = q_b_a * pair.a.f;
  return std::atan2(turned.cross(pair.b.f).norm(), turned.dot(pair.b.f));
}

bool hasParallax(const Eigen::Quaterniond& q_b_a, const RayPair& pair, double sigma_px) {
  const double px_per_rad = 0.5 * (pair.a.px_per_rad + pair.b.px_per_rad);
  return rayParallax(q_b_a, pair) * px_per_rad > kParallaxSigmas * sigma_px;
}

PoseHypothesis bestOfFourPoses(const RefinedPose& refined,
                               std::span<const RayPair> pairs,
                               double sigma_px) {
  PoseHypothesis best;
  int best_balance = 0;
  bool first = true;
  for (const SE3d& T_b_a : posesOfEssential(essentialOf(refined.T_b_a))) {
    const PoseHypothesis pose = assess(T_b_a, pairs, sigma_px);
    const int balance = pose.front - pose.behind;
    if (!first && balance <= best_balance) continue;
    best = pose;
    best_balance = balance;
    first = false;
  }
  best.direction_std = refined.direction_std;
  return best;
}

}  // namespace glide
