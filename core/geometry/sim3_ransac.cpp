#include "geometry/sim3_ransac.h"

#include "geometry/align_sim3.h"
#include "geometry/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

namespace glide {
namespace {

constexpr std::size_t kSampleSize = 3;

/// Times that the points of all inliers are aligned and the inliers chosen anew.
constexpr int kRefitRounds = 2;

/// Sum of what is left of the threshold over the inliers (MSAC), and their number.
struct Support {
  double score = 0.0;
  int inliers = 0;
};

struct Candidate {
  Sim3d S_a_b;
  Support support;
};

/// Error of a point of one frame in the image of the other.
double error2(const CameraModel& camera, const Vec3d& p_cam, const Vec2d& uv, double inv_sigma) {
  const std::optional<Vec2d> projected = camera.project(p_cam);
  return projected ? (*projected - uv).squaredNorm() * inv_sigma * inv_sigma
                   : std::numeric_limits<double>::infinity();
}

Support supportOf(const CameraModel& camera,
                  const Sim3d& S_a_b,
                  std::span<const Sim3Pair> pairs,
                  double max_error2) {
  Support support;
  for (const Sim3Pair& pair : pairs) {
    const double margin = max_error2 - pairError2(camera, S_a_b, pair);
    if (!(margin > 0.0)) continue;
    support.score += margin;
    ++support.inliers;
  }
  return support;
}

std::optional<Sim3d> fromSample(std::span<const Sim3Pair> pairs,
                                const std::array<std::size_t, kSampleSize>& picked) {
  std::array<Vec3d, kSampleSize> points_a, points_b;
  for (std::size_t i = 0; i < kSampleSize; ++i) {
    points_a[i] = pairs[picked[i]].p_a;
    points_b[i] = pairs[picked[i]].p_b;
  }
  return alignSim3(points_a, points_b, AlignScale::estimated);
}

Candidate search(const CameraModel& camera,
                 std::span<const Sim3Pair> pairs,
                 const Sim3RansacOptions& options) {
  Candidate best;
  std::mt19937_64 rng(options.seed);
  for (int i = 0; i < options.iterations; ++i) {
    const auto sample = fromSample(pairs, sampleDistinct<kSampleSize>(pairs.size(), rng));
    if (!sample) continue;
    const Support support = supportOf(camera, *sample, pairs, options.max_error2);
    if (support.score > best.support.score) best = {*sample, support};
    const double share = best.support.inliers / static_cast<double>(pairs.size());
    if (i + 1 >= samplesNeeded(share, kSampleSize)) break;
  }
  return best;
}

Candidate refit(const CameraModel& camera,
                std::span<const Sim3Pair> pairs,
                const Candidate& start,
                double max_error2) {
  Candidate best = start;
  for (int round = 0; round < kRefitRounds; ++round) {
    std::vector<Vec3d> points_a, points_b;
    for (const Sim3Pair& pair : pairs) {
      if (!(pairError2(camera, best.S_a_b, pair) < max_error2)) continue;
      points_a.push_back(pair.p_a);
      points_b.push_back(pair.p_b);
    }
    const auto fitted = alignSim3(points_a, points_b, AlignScale::estimated);
    if (!fitted) break;
    const Support support = supportOf(camera, *fitted, pairs, max_error2);
    if (!(support.score > best.support.score)) break;
    best = {*fitted, support};
  }
  return best;
}

}  // namespace

double pairError2(const CameraModel& camera, const Sim3d& S_a_b, const Sim3Pair& pair) {
  const Vec3d p_a = S_a_b * pair.p_b;
  const Vec3d p_b = S_a_b.q.conjugate() * (pair.p_a - S_a_b.t) / S_a_b.s;
  const double depth = 0.5 * std::log(p_a.squaredNorm() / pair.p_a.squaredNorm()) / kLogDepthSigma;
  return std::max({error2(camera, p_a, pair.uv_a, pair.inv_sigma_a),
                   error2(camera, p_b, pair.uv_b, pair.inv_sigma_b),
                   depth * depth});
}

std::optional<Sim3RansacResult> solveSim3(const CameraModel& camera,
                                          std::span<const Sim3Pair> pairs,
                                          const Sim3RansacOptions& options) {
  const int enough = std::max(options.min_inliers, static_cast<int>(kSampleSize) + 1);
  if (static_cast<int>(pairs.size()) < enough) return std::nullopt;
  const Candidate found = search(camera, pairs, options);
  if (found.support.inliers <= static_cast<int>(kSampleSize)) return std::nullopt;
  const Candidate best = refit(camera, pairs, found, options.max_error2);
  if (best.support.inliers < enough) return std::nullopt;

  Sim3RansacResult result;
  result.S_a_b = best.S_a_b;
  result.inliers = best.support.inliers;
  for (const Sim3Pair& pair : pairs) {
    result.inlier.push_back(pairError2(camera, best.S_a_b, pair) < options.max_error2);
  }
  return result;
}

}  // namespace glide
