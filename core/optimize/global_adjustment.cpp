#include "optimize/global_adjustment.h"

#include "optimize/bundle_problem.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace glide {
namespace {

// A pair has been adjusted when the map began, and a pair alone has no drift.
constexpr std::size_t kMinKeyframes = 3;
// The first round, with Huber's loss, pulls the map together; the second decides without outliers.
constexpr int kRounds = 2;
// A long map bends so easily that the window's damping would hold it: 3 iterations instead of 6 for
// 300 keyframes.
constexpr double kTrustRegion = 1e7;

Vec3d centerOf(const SE3d& T_cam_world) { return T_cam_world.inverse().t; }

/// Cameras in the order of the snapshot's keyframes, points in the order of its landmarks.
BundleProblem problemOf(const MapSnapshot& map, const ScaleLevels& levels) {
  BundleProblem problem;
  std::map<KeyframeId, int> camera_of;
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
    camera_of.emplace(keyframe.id, static_cast<int>(problem.cameras.size()));
    problem.cameras.push_back({keyframe.T_cam_world});
  }
  problem.cameras.front().fixed = true;
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    const int point = static_cast<int>(problem.points.size());
    problem.points.push_back(landmark.p_world);
    for (const Observation& seen : landmark.observations) {
      const int camera = camera_of.at(seen.keyframe);
      const FeatureSet& features = *map.keyframes()[std::size_t(camera)].features;
      const Vec2d uv = features.feature(std::size_t(seen.feature)).uv.cast<double>();
      problem.observations.push_back({camera, point, uv, 1.0 / levels.scale(seen.level)});
    }
  }
  return problem;
}

/// Mean distance of the cameras from the first.
double spreadOf(const BundleProblem& problem) {
  const Vec3d first = centerOf(problem.cameras.front().T_cam_world);
  double sum = 0.0;
  for (const BundleProblem::Camera& camera : problem.cameras) {
    sum += (centerOf(camera.T_cam_world) - first).norm();
  }
  return sum / static_cast<double>(problem.cameras.size());
}

/// Scales the world about the first camera, which stays.
void rescale(double factor, BundleProblem* problem) {
  const Vec3d first = centerOf(problem->cameras.front().T_cam_world);
  for (std::size_t i = 1; i < problem->cameras.size(); ++i) {
    SE3d& T_cam_world = problem->cameras[i].T_cam_world;
    const Vec3d center = first + factor * (centerOf(T_cam_world) - first);
    T_cam_world.t = -(T_cam_world.q * center);
  }
  for (Vec3d& point : problem->points) point = first + factor * (point - first);
}

/// By which factor the distances of each camera's landmarks have grown: the median over those it
/// sees well, 1 where there are none.
std::vector<double> growthOfViews(const MapSnapshot& map, const BundleProblem& solved) {
  std::vector<std::vector<double>> ratios(solved.cameras.size());
  for (const BundleObservation& seen : solved.observations) {
    if (!seen.inlier) continue;
    const auto camera = std::size_t(seen.camera), point = std::size_t(seen.point);
    const Vec3d p_old = map.keyframes()[camera].T_cam_world * map.landmarks()[point].p_world;
    const Vec3d p_new = solved.cameras[camera].T_cam_world * solved.points[point];
    if (p_old.norm() > 0.0) ratios[camera].push_back(p_new.norm() / p_old.norm());
  }
  std::vector<double> growth(solved.cameras.size(), 1.0);
  for (std::size_t i = 0; i < growth.size(); ++i) {
    const auto middle = ratios[i].begin() + std::ptrdiff_t(ratios[i].size() / 2);
    std::nth_element(ratios[i].begin(), middle, ratios[i].end());
    if (middle != ratios[i].end() && *middle > 0.0) growth[i] = *middle;
  }
  return growth;
}

/// World, old to new, around a camera: into its frame, grown there, and out again.
Sim3d moveOf(const SE3d& T_cam_old, const SE3d& T_cam_new, double growth) {
  const Sim3d S_cam_old{T_cam_old.q, T_cam_old.t, 1.0};
  const Sim3d S_cam_new{T_cam_new.q, T_cam_new.t, 1.0};
  const Sim3d S_growth{Eigen::Quaterniond::Identity(), Vec3d::Zero(), growth};
  return S_cam_new.inverse() * S_growth * S_cam_old;
}

GlobalAdjustment differenceFrom(const MapSnapshot& map, const BundleProblem& solved) {
  GlobalAdjustment adjustment;
  adjustment.snapshot = {map.generation(), map.corrections()};
  const std::vector<double> growth = growthOfViews(map, solved);
  adjustment.keyframes.reserve(solved.cameras.size());
  for (std::size_t i = 0; i < solved.cameras.size(); ++i) {
    const MapSnapshot::KeyframeEntry& old = map.keyframes()[i];
    adjustment.keyframes.push_back(
        {old.id, moveOf(old.T_cam_world, solved.cameras[i].T_cam_world, growth[i])});
  }
  adjustment.landmarks.reserve(solved.points.size());
  for (std::size_t i = 0; i < solved.points.size(); ++i) {
    adjustment.landmarks.push_back(
        {map.landmarks()[i].id, solved.points[i] - map.landmarks()[i].p_world});
  }
  return adjustment;
}

}  // namespace

std::optional<GlobalAdjustment> adjustGlobally(const CameraModel& camera,
                                               const MapSnapshot& map,
                                               const GlobalAdjustmentOptions& options) {
  if (map.keyframes().size() < kMinKeyframes || map.landmarks().empty()) return std::nullopt;
  BundleProblem problem = problemOf(map, options.levels);
  const double spread = spreadOf(problem);

  BundleOptions bundle_options;
  bundle_options.max_iterations = options.max_iterations;
  bundle_options.rounds = kRounds;
  bundle_options.trust_region_radius = kTrustRegion;
  bundle_options.cancel = options.cancel;
  const BundleSummary summary = solveBundle(map.cameraOr(camera), bundle_options, &problem);
  if (!summary.usable || summary.cancelled) return std::nullopt;

  const double solved_spread = spreadOf(problem);
  if (!(solved_spread > 0.0)) return std::nullopt;
  rescale(spread / solved_spread, &problem);
  return differenceFrom(map, problem);
}

}  // namespace glide
