#pragma once

#include "support/synthetic_problem.h"

#include "geometry/sim3_ransac.h"

#include <random>
#include <vector>

namespace glide::test {

struct Sim3PairOptions {
  int pairs = 100;
  double noise_px = 0.0;       ///< of the pixels, per axis
  double outlier_share = 0.0;  ///< the first ones: points that have nothing to do with each other
  std::uint64_t seed = 1;
};

/// How one frame's unit and pose may differ from another's.
inline Sim3d someSimilarity() {
  return {so3Exp(Vec3d(0.1, -0.3, 0.05)), Vec3d(0.8, -0.2, 0.4), 1.6};
}

/// Points in front of two cameras that are `S_a_b` apart, as both see them.
inline std::vector<Sim3Pair> makeSim3Pairs(const CameraModel& camera,
                                           const Sim3d& S_a_b,
                                           const Sim3PairOptions& options) {
  std::mt19937_64 random(options.seed);
  std::uniform_real_distribution<double> side(-2.0, 2.0), depth(3.0, 8.0);
  const Vec3d center(0.0, 0.0, 5.0);
  std::vector<Sim3Pair> pairs;
  while (static_cast<int>(pairs.size()) < options.pairs) {
    Sim3Pair pair;
    pair.p_b = Vec3d{side(random), side(random), depth(random)};
    const bool outlier = static_cast<double>(pairs.size()) < options.outlier_share * options.pairs;
    pair.p_a = outlier ? Vec3d(center + randomVector(1.5, &random)) : S_a_b * pair.p_b;
    const auto uv_a = camera.project(pair.p_a), uv_b = camera.project(pair.p_b);
    if (!uv_a || !uv_b || !camera.isInImage(*uv_a, 0.0) || !camera.isInImage(*uv_b, 0.0)) continue;
    pair.uv_a = *uv_a + randomVector(options.noise_px, &random).head<2>();
    pair.uv_b = *uv_b + randomVector(options.noise_px, &random).head<2>();
    pairs.push_back(pair);
  }
  return pairs;
}

/// Size of log(S_b_a * S_truth).
inline double similarityError(const Sim3d& S_a_b, const Sim3d& S_truth) {
  return (S_a_b.inverse() * S_truth).log().norm();
}

}  // namespace glide::test
