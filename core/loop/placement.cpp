#include "loop/placement.h"

#include "map/local_map.h"
#include "optimize/landmark_search.h"

#include "base/median.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace glide {
namespace {

// Windows in units of the tracker's: the pose of a dozen matches is good to some pixels, the one
// after it to less than one.
constexpr std::array<double, 2> kWindows = {3.0, 1.0};

constexpr int kMaxKeyframes = 20;

// Two placements that differ by less are one: a multiple of the error allowed at room scale (5 cm,
// 2 degrees), far less than what lies between repeated things.
constexpr double kSameDistance = 0.05;  // over the median depth
constexpr double kSameAngle = 0.05;     // radians

std::vector<LandmarkId> idsOf(const LandmarkMatches& matches) {
  std::vector<LandmarkId> ids;
  for (const MapSnapshot::LandmarkEntry* landmark : matches.of_feature) {
    if (landmark != nullptr) ids.push_back(landmark->id);
  }
  return ids;
}

int occupiedCells(const CameraModel& camera,
                  const FeatureSet& features,
                  const LandmarkMatches& matches) {
  constexpr std::size_t kGrid = Placement::kGrid;
  std::array<bool, kGrid * kGrid> occupied{};
  const auto cell = [](float position, int size) {
    const auto index =
        static_cast<int>(position * static_cast<float>(kGrid) / static_cast<float>(size));
    return static_cast<std::size_t>(std::clamp(index, 0, Placement::kGrid - 1));
  };
  for (std::size_t i = 0; i < matches.of_feature.size(); ++i) {
    if (matches.of_feature[i] == nullptr) continue;
    const Vec2f& uv = features.feature(i).uv;
    occupied[cell(uv.y(), camera.height()) * kGrid + cell(uv.x(), camera.width())] = true;
  }
  return static_cast<int>(std::count(occupied.begin(), occupied.end(), true));
}

/// How many of the landmarks in view tracking would find, going by its record.
double likelyCount(std::span<const MapSnapshot::LandmarkEntry* const> visible) {
  double sum = 0.0;
  for (const MapSnapshot::LandmarkEntry* landmark : visible)
    sum += static_cast<double>(landmark->found_count) / std::max(landmark->visible_count, 1);
  return sum;
}

double medianDepth(const SE3d& T_cam_world, const LandmarkMatches& matches) {
  std::vector<double> depths;
  for (const MapSnapshot::LandmarkEntry* landmark : matches.of_feature) {
    if (landmark != nullptr) depths.push_back((T_cam_world * landmark->p_world).norm());
  }
  return median(std::move(depths), 1.0);
}

/// Standard deviation of the camera's position in its least certain direction, scene units.
double positionSigma(const PoseEstimate& pose) {
  const Mat6d covariance = pose.H.ldlt().solve(Mat6d::Identity());
  // The camera's centre moves against the translation of a left perturbation, in camera axes.
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(covariance.topLeftCorner<3, 3>(),
                                                    Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues().maxCoeff(), 0.0));
}

}  // namespace

std::optional<Placement> widen(const Config& config,
                               const CameraModel& camera,
                               const MapSnapshot& map,
                               const FeatureSet& features,
                               const PoseSuggestion& suggestion) {
  const LocalMapLimits limits{kMaxKeyframes, config.indirect.max_local_landmarks};
  LandmarkSearch search(config, camera);
  LocalMap local = collectLocalMap(map, suggestion.seen, limits);
  LandmarkMatches matches;
  PoseEstimate pose;
  Placement placement;
  placement.T_cam_world = suggestion.T_cam_world;
  placement.recognized = static_cast<int>(suggestion.seen.size());
  for (const double window : kWindows) {
    matches = LandmarkMatches();
    search.beginFrame();
    search.extend(local.landmarks,
                  features,
                  {placement.T_cam_world,
                   window * config.indirect.search_radius_px,
                   config.indirect.max_descriptor_distance},
                  &matches);
    placement.matched = matches.count;
    pose = search.refine(placement.T_cam_world, features, &matches);
    if (!pose.valid) return std::nullopt;
    placement.T_cam_world = pose.T_cam_world;
    local = collectLocalMap(map, idsOf(matches), limits);
  }
  placement.reference = local.reference;
  placement.likely = likelyCount(search.visible());
  placement.inliers = matches.count;
  placement.cells = occupiedCells(camera, features, matches);
  placement.median_depth = medianDepth(placement.T_cam_world, matches);
  placement.position_sigma = positionSigma(pose) / placement.median_depth;
  return placement;
}

bool areSame(const Placement& a, const SE3d& T_cam_world) {
  const SE3d T_a_b = a.T_cam_world * T_cam_world.inverse();
  return T_a_b.t.norm() < kSameDistance * a.median_depth && so3Log(T_a_b.q).norm() < kSameAngle;
}

}  // namespace glide
