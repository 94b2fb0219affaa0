#include "replay/render/framing.h"

#include "replay/outputs/run_trajectories.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace glide::replay {
namespace {

constexpr double kViewSlope = 0.7;  // tangent of the half field of view that counts as "before"
constexpr double kDepthCut = 2.0;   // in median depths: what is farther would only shrink the rest
constexpr double kFocusShare = 0.65;  // of the way to what it sees: there is more of it
constexpr double kReach = 1.5;        // in distances of the farthest landmark before the camera
constexpr std::size_t kRecentKeyframes = 20;
constexpr double kUprightPrior = 0.02;  // of the mean upward axis against the level x axes

Vec3d point(const MapView::Landmark& landmark) {
  return {landmark.p_world[0], landmark.p_world[1], landmark.p_world[2]};
}

/// The value that a share of the values does not exceed. Not empty; reorders.
double quantile(std::vector<double>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

Vec3d medianOf(const std::vector<Vec3d>& points) {
  Vec3d median;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(
        points.begin(), points.end(), values.begin(), [&](const Vec3d& p) { return p[axis]; });
    median[axis] = quantile(values, 0.5);
  }
  return median;
}

/// Landmarks that a camera would see if nothing hid them, without the far ones.
std::vector<Vec3d> pointsBefore(const MapView& map, const SE3d& T_world_cam) {
  const SE3d T_cam_world = T_world_cam.inverse();
  std::vector<Vec3d> points;
  std::vector<double> depths;
  for (const MapView::Landmark& landmark : map.landmarks) {
    const Vec3d p_cam = T_cam_world * point(landmark);
    if (p_cam.head<2>().norm() > kViewSlope * p_cam.z()) continue;
    points.push_back(point(landmark));
    depths.push_back(p_cam.z());
  }
  if (points.empty()) return points;
  std::vector<double> sorted = depths;
  const double cut = kDepthCut * quantile(sorted, 0.5);
  std::vector<Vec3d> near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (depths[i] <= cut) near.push_back(points[i]);
  }
  return near;
}

std::vector<Vec3d> keyframePositions(const MapView& map, std::size_t newest) {
  std::vector<Vec3d> positions;
  for (auto key = map.keyframes.rbegin(); key != map.keyframes.rend(); ++key) {
    if (positions.size() == newest) break;
    if (!key->retired) positions.push_back(toSE3(key->T_world_cam).t);
  }
  return positions;
}

double largestDistance(const std::vector<Vec3d>& points, const Vec3d& from) {
  double largest = 0.0;
  for (const Vec3d& p : points) largest = std::max(largest, (p - from).norm());
  return largest;
}

}  // namespace

std::optional<Framing> frameAround(const MapView& map, const SE3d& T_world_cam) {
  Framing framing;
  framing.landmarks = pointsBefore(map, T_world_cam);
  if (framing.landmarks.empty()) return std::nullopt;
  framing.focus = T_world_cam.t + kFocusShare * (medianOf(framing.landmarks) - T_world_cam.t);
  framing.cameras = keyframePositions(map, kRecentKeyframes);
  // A path that leads away must not make the picture ever wider: old parts may leave it.
  const double reach = kReach * largestDistance(framing.landmarks, T_world_cam.t);
  const auto is_far = [&](const Vec3d& p) { return (p - T_world_cam.t).norm() > reach; };
  framing.cameras.erase(std::remove_if(framing.cameras.begin(), framing.cameras.end(), is_far),
                        framing.cameras.end());
  framing.cameras.push_back(T_world_cam.t);
  framing.up = upOf(map);
  framing.ahead = T_world_cam.q * Vec3d::UnitZ();
  return framing;
}

Vec3d upOf(const MapView& map) {
  Mat3d level = Mat3d::Zero();
  Vec3d upward = Vec3d::Zero();
  for (const MapView::Keyframe& key : map.keyframes) {
    const Mat3d R_world_cam = toSE3(key.T_world_cam).rotation();
    level += R_world_cam.col(0) * R_world_cam.col(0).transpose();
    upward -= R_world_cam.col(1);
  }
  if (upward.norm() == 0.0) return -Vec3d::UnitY();
  upward.normalize();
  // The direction that the x axes and the deviation from `upward` have least of.
  const double count = static_cast<double>(map.keyframes.size());
  const Mat3d cost =
      level / count + kUprightPrior * (Mat3d::Identity() - upward * upward.transpose());
  const Vec3d up = Eigen::SelfAdjointEigenSolver<Mat3d>(cost).eigenvectors().col(0);
  return up.dot(upward) < 0.0 ? Vec3d(-up) : up;
}

}  // namespace glide::replay
