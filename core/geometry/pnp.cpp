#include "geometry/pnp.h"

#include "geometry/p3p.h"
#include "geometry/robust.h"
#include "geometry/sampling.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr std::size_t kSampleSize = 3;

/// Rounds of Gauss-Newton on the inliers followed by a new choice of inliers.
constexpr int kRefineRounds = 3;
constexpr int kStepsPerRound = 4;

/// A point and its observation, in both forms that the search needs.
struct Observation {
  Vec3d p_world;
  Vec2d uv;
  Vec3d bearing;
  std::size_t index = 0;
};

/// Sum of what is left of the threshold over the inliers (MSAC), and their number.
struct Support {
  double score = 0.0;
  int inliers = 0;
};

double squaredError(const CameraModel& camera, const SE3d& T_cam_world, const Observation& seen) {
  const std::optional<Vec2d> uv = camera.project(T_cam_world * seen.p_world);
  return uv ? (*uv - seen.uv).squaredNorm() : std::numeric_limits<double>::infinity();
}

std::vector<Observation> usableObservations(const CameraModel& camera,
                                            std::span<const PointPixel> points) {
  std::vector<Observation> seen;
  seen.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<Vec3d> bearing = camera.unproject(points[i].uv);
    if (bearing) seen.push_back({points[i].p_world, points[i].uv, *bearing, i});
  }
  return seen;
}

Support supportOf(const CameraModel& camera,
                  const SE3d& T_cam_world,
                  std::span<const Observation> seen,
                  double threshold_px) {
  Support support;
  for (const Observation& s : seen) {
    const double margin = threshold_px * threshold_px - squaredError(camera, T_cam_world, s);
    if (!(margin > 0.0)) continue;
    support.score += margin;
    ++support.inliers;
  }
  return support;
}

struct Candidate {
  SE3d T_cam_world;
  Support support;
};

Candidate searchPose(const CameraModel& camera,
                     std::span<const Observation> seen,
                     const PnpOptions& options) {
  Candidate best;
  std::mt19937_64 rng(options.seed);
  for (int i = 0; i < options.iterations; ++i) {
    PointBearings sample;
    const auto picked = sampleDistinct<kSampleSize>(seen.size(), rng);
    for (std::size_t j = 0; j < kSampleSize; ++j) {
      sample.p_world[j] = seen[picked[j]].p_world;
      sample.bearing[j] = seen[picked[j]].bearing;
    }
    for (const SE3d& T_cam_world : solveP3p(sample)) {
      const Support support = supportOf(camera, T_cam_world, seen, options.threshold_px);
      if (support.score > best.support.score) best = {T_cam_world, support};
    }
    const double share = best.support.inliers / static_cast<double>(seen.size());
    if (i + 1 >= samplesNeeded(share, kSampleSize)) break;
  }
  return best;
}

/// One step of Gauss-Newton on the reprojection error of the inliers, Huber at half the threshold.
SE3d improved(const CameraModel& camera,
              const SE3d& T_cam_world,
              std::span<const Observation> seen,
              double threshold_px) {
  Mat6d H = Mat6d::Zero();
  Vec6d b = Vec6d::Zero();
  for (const Observation& s : seen) {
    const Vec3d p_cam = T_cam_world * s.p_world;
    const std::optional<Projection> projection = camera.projectWithJacobian(p_cam);
    if (!projection) continue;
    const Vec2d residual = projection->uv - s.uv;
    const double error = residual.norm();
    if (!(error < threshold_px)) continue;
    Mat26d J_residual_pose;
    J_residual_pose << projection->J_uv_point, -projection->J_uv_point * skew(p_cam);
    const double weight = huberWeight(error, 0.5 * threshold_px);
    H.noalias() += weight * J_residual_pose.transpose() * J_residual_pose;
    b.noalias() -= weight * J_residual_pose.transpose() * residual;
  }
  const Vec6d step = H.ldlt().solve(b);
  return step.allFinite() ? SE3d::exp(step) * T_cam_world : T_cam_world;
}

Candidate refine(const CameraModel& camera,
                 const Candidate& start,
                 std::span<const Observation> seen,
                 double threshold_px) {
  Candidate best = start;
  SE3d T_cam_world = start.T_cam_world;
  for (int round = 0; round < kRefineRounds; ++round) {
    for (int step = 0; step < kStepsPerRound; ++step) {
      T_cam_world = improved(camera, T_cam_world, seen, threshold_px);
    }
    const Support support = supportOf(camera, T_cam_world, seen, threshold_px);
    if (support.score > best.support.score) best = {T_cam_world, support};
  }
  return best;
}

}  // namespace

std::optional<PnpResult> solvePnp(const CameraModel& camera,
                                  std::span<const PointPixel> points,
                                  const PnpOptions& options) {
  const std::vector<Observation> seen = usableObservations(camera, points);
  const int enough = std::max(options.min_inliers, static_cast<int>(kSampleSize) + 1);
  if (static_cast<int>(seen.size()) < enough) return std::nullopt;
  const Candidate found = searchPose(camera, seen, options);
  if (found.support.inliers <= static_cast<int>(kSampleSize)) return std::nullopt;
  const Candidate best = refine(camera, found, seen, options.threshold_px);
  if (best.support.inliers < enough) return std::nullopt;

  PnpResult result;
  result.T_cam_world = best.T_cam_world;
  result.inliers = best.support.inliers;
  result.inlier.assign(points.size(), false);
  for (const Observation& s : seen) {
    const double error2 = squaredError(camera, best.T_cam_world, s);
    result.inlier[s.index] = error2 < options.threshold_px * options.threshold_px;
  }
  return result;
}

}  // namespace glide
