#include "ar/surfaces.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glide {
namespace {

// Shares of the image's width. A finger covers about 3 % of a phone's screen.
constexpr double kPointRadius = 0.03;
constexpr double kPlaneRadius = 0.12;
constexpr std::size_t kMinPlanePoints = 6;
// Landmarks that are farther or nearer than this share of the median depth belong to another
// surface.
constexpr double kDepthGap = 0.25;
// A plane: spread across it at most this share of the spread along it.
constexpr double kFlatness = 0.15;
// Planes seen at less than this angle (sine) give hits anywhere.
constexpr double kMinGrazing = 0.1;

double squaredDistance(const VisiblePoint& point, const Vec2d& uv) {
  return (point.uv - uv).squaredNorm();
}

/// A frame at `p` whose -y axis is `normal`.
SE3d standOn(const Vec3d& p, const Vec3d& normal) {
  return {Eigen::Quaterniond::FromTwoVectors(Vec3d(0.0, -1.0, 0.0), normal), p};
}

/// The landmarks around the pixel that are about as deep as most of them.
std::vector<Vec3d> surfacePoints(const std::vector<VisiblePoint>& visible,
                                 const Vec2d& uv,
                                 double radius) {
  std::vector<Vec3d> points;
  for (const VisiblePoint& point : visible) {
    if (squaredDistance(point, uv) <= radius * radius) points.push_back(point.p_cam);
  }
  if (points.size() < kMinPlanePoints) return {};
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  std::nth_element(points.begin(), middle, points.end(), [](const Vec3d& a, const Vec3d& b) {
    return a.z() < b.z();
  });
  const double depth = middle->z();
  points.erase(
      std::remove_if(points.begin(),
                     points.end(),
                     [&](const Vec3d& p) { return std::abs(p.z() - depth) > kDepthGap * depth; }),
      points.end());
  return points;
}

std::optional<SurfaceHit> planeHit(const std::vector<Vec3d>& points, const Vec3d& ray) {
  if (points.size() < kMinPlanePoints) return std::nullopt;
  Vec3d mean = Vec3d::Zero();
  for (const Vec3d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Mat3d scatter = Mat3d::Zero();
  for (const Vec3d& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(scatter);  // ascending
  const Vec3d spread = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  if (spread[0] > kFlatness * spread[1]) return std::nullopt;
  Vec3d normal = solver.eigenvectors().col(0);
  if (normal.dot(ray) > 0.0) normal = -normal;
  const double grazing = -normal.dot(ray);
  const double distance = normal.dot(mean) / normal.dot(ray);
  if (grazing < kMinGrazing || !(distance > 0.0)) return std::nullopt;
  return SurfaceHit{standOn(distance * ray, normal), distance, static_cast<int>(points.size())};
}

}  // namespace

std::vector<VisiblePoint> visiblePoints(const MapView& map,
                                        const CameraModel& camera,
                                        const SE3d& T_cam_world) {
  std::vector<VisiblePoint> visible;
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const auto& p = map.landmarks[i].p_world;
    const Vec3d p_cam = T_cam_world * Vec3d(p[0], p[1], p[2]);
    const std::optional<Vec2d> uv = camera.project(p_cam);
    if (uv && camera.isInImage(*uv, 0.0)) visible.push_back({i, p_cam, *uv});
  }
  return visible;
}

std::vector<SurfaceHit> hitTest(const std::vector<VisiblePoint>& visible,
                                const CameraModel& camera,
                                const Vec2d& uv) {
  std::vector<SurfaceHit> hits;
  const std::optional<Vec3d> ray = camera.unproject(uv);
  if (!ray || visible.empty()) return hits;
  const std::optional<SurfaceHit> plane =
      planeHit(surfacePoints(visible, uv, kPlaneRadius * camera.width()), *ray);
  if (plane) hits.push_back(*plane);
  const auto nearest =
      std::min_element(visible.begin(), visible.end(), [&](const auto& a, const auto& b) {
        return squaredDistance(a, uv) < squaredDistance(b, uv);
      });
  if (std::sqrt(squaredDistance(*nearest, uv)) <= kPointRadius * camera.width()) {
    const Vec3d& p = nearest->p_cam;
    hits.push_back({standOn(p, -p.normalized()), p.norm(), 1});
  }
  std::sort(hits.begin(), hits.end(), [](const SurfaceHit& a, const SurfaceHit& b) {
    return a.distance < b.distance;
  });
  return hits;
}

}  // namespace glide
