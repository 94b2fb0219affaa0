#include "support/synthetic_problem.h"

#include <algorithm>
#include <cmath>

namespace glide::test {
namespace {

constexpr double kMinOutlierPx = 20.0;

/// Camera at `center` whose z axis points at the world's origin and whose y axis points down (world
/// +y).
SE3d lookAtOrigin(const Vec3d& center) {
  const Vec3d z = -center.normalized();
  const Vec3d x = Vec3d::UnitY().cross(z).normalized();
  Mat3d R_world_cam;
  R_world_cam << x, z.cross(x), z;
  SE3d T_cam_world;
  T_cam_world.q = Eigen::Quaterniond(Mat3d(R_world_cam.transpose())).normalized();
  T_cam_world.t = -(T_cam_world.q * center);
  return T_cam_world;
}

std::vector<SE3d> makeCameras(const SyntheticOptions& options) {
  std::vector<SE3d> cameras;
  for (int i = 0; i < options.cameras; ++i) {
    const double share = options.cameras > 1 ? double(i) / (options.cameras - 1) - 0.5 : 0.0;
    const double angle = share * options.arc_rad;
    // A slight wave up and down and in depth: no camera lies on a line or in a plane with the
    // others.
    const Vec3d center(options.arc_radius * std::sin(angle),
                       0.1 * options.arc_radius * std::sin(2.3 * i),
                       -options.arc_radius * (std::cos(angle) + 0.05 * std::cos(1.7 * i)));
    cameras.push_back(lookAtOrigin(center));
  }
  return cameras;
}

std::vector<Vec3d> makePoints(const SyntheticOptions& options, std::mt19937_64* rng) {
  std::uniform_real_distribution<double> side(-options.ball_radius, options.ball_radius);
  std::vector<Vec3d> points;
  while (points.size() < std::size_t(options.points)) {
    const Vec3d p{side(*rng), side(*rng), side(*rng)};  // braces: one after another
    if (p.norm() < options.ball_radius) points.push_back(p);
  }
  return points;
}

std::vector<SyntheticObservation> viewsOf(const CameraModel& camera,
                                          const SyntheticProblem& problem,
                                          int point) {
  std::vector<SyntheticObservation> views;
  for (int c = 0; c < int(problem.T_cam_world.size()); ++c) {
    const auto uv =
        camera.project(problem.T_cam_world[std::size_t(c)] * problem.points[std::size_t(point)]);
    if (uv && camera.isInImage(*uv, 0.0)) views.push_back({c, point, *uv, false});
  }
  return views;
}

Vec2d farPixel(const CameraModel& camera, const Vec2d& uv, std::mt19937_64* rng) {
  std::uniform_real_distribution<double> x(0.0, camera.width() - 1.0);
  std::uniform_real_distribution<double> y(0.0, camera.height() - 1.0);
  for (;;) {
    Vec2d candidate{x(*rng), y(*rng)};
    if ((candidate - uv).norm() > kMinOutlierPx) return candidate;
  }
}

}  // namespace

SyntheticProblem makeSyntheticProblem(const CameraModel& camera, const SyntheticOptions& options) {
  std::mt19937_64 rng(options.seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  std::bernoulli_distribution is_outlier(options.outlier_share);
  SyntheticProblem problem;
  problem.T_cam_world = makeCameras(options);
  problem.points = makePoints(options, &rng);
  for (int p = 0; p < options.points; ++p) {
    std::vector<SyntheticObservation> views = viewsOf(camera, problem, p);
    std::shuffle(views.begin(), views.end(), rng);
    views.resize(std::min(views.size(), std::size_t(options.max_views_per_point)));
    for (SyntheticObservation& view : views) {
      view.outlier = is_outlier(rng);
      if (view.outlier) view.uv = farPixel(camera, view.uv, &rng);
      view.uv += options.noise_px * Vec2d{gauss(rng), gauss(rng)};
      problem.observations.push_back(view);
    }
  }
  std::sort(
      problem.observations.begin(), problem.observations.end(), [](const auto& a, const auto& b) {
        return a.camera != b.camera ? a.camera < b.camera : a.point < b.point;
      });
  return problem;
}

CameraModel syntheticCamera(DistortionModel distortion) {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = 381.0;
  intrinsics.fy = 379.0;
  intrinsics.cx = 322.5;
  intrinsics.cy = 238.7;
  intrinsics.distortion = distortion;
  if (distortion == DistortionModel::radial_tangential) {
    intrinsics.coefficients = {-0.28, 0.074, 1.9e-4, 1.8e-5};
  } else if (distortion == DistortionModel::kannala_brandt4) {
    intrinsics.coefficients = {0.021, -0.012, 0.008, -0.0024};
  }
  return CameraModel::create(intrinsics).value();
}

Vec3d randomVector(double sigma, std::mt19937_64* rng) {
  std::normal_distribution<double> gauss(0.0, sigma);
  const double x = gauss(*rng);
  const double y = gauss(*rng);
  const double z = gauss(*rng);
  return {x, y, z};
}

SE3d perturbed(const SE3d& T_a_b,
               double sigma_translation,
               double sigma_rad,
               std::mt19937_64* rng) {
  Vec6d twist;
  twist.head<3>() = randomVector(sigma_translation, rng);
  twist.tail<3>() = randomVector(sigma_rad, rng);
  return SE3d::exp(twist) * T_a_b;
}

double translationError(const SE3d& T_a_b, const SE3d& T_truth) {
  return (T_a_b * T_truth.inverse()).log().head<3>().norm();
}

double rotationError(const SE3d& T_a_b, const SE3d& T_truth) {
  return (T_a_b * T_truth.inverse()).log().tail<3>().norm();
}

}  // namespace glide::test
