#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <cstdint>
#include <random>
#include <vector>

namespace glide::test {

/// Cameras on an arc around a ball of points, all looking at its middle (the world's origin).
struct SyntheticOptions {
  int cameras = 8;
  int points = 300;
  double ball_radius = 1.5;        ///< of the points, world units
  double arc_radius = 4.0;         ///< distance of the cameras from the origin, world units
  double arc_rad = 1.0;            ///< angle from the first camera to the last, radians
  int max_views_per_point = 1000;  ///< a random choice of the views in which the point is visible
  double noise_px = 0.0;           ///< standard deviation per axis
  double outlier_share = 0.0;  ///< share of the observations moved to a random pixel, >= 20 px away
  std::uint64_t seed = 1;
};

struct SyntheticObservation {
  int camera = 0;
  int point = 0;
  Vec2d uv;              ///< distorted pixel inside of the image, with noise
  bool outlier = false;  ///< moved to a random pixel
};

/// The truth and what the cameras saw of it. Observations are sorted by camera, then point.
struct SyntheticProblem {
  std::vector<SE3d> T_cam_world;
  std::vector<Vec3d> points;
  std::vector<SyntheticObservation> observations;
};

/// The same options and camera give the same problem.
SyntheticProblem makeSyntheticProblem(const CameraModel& camera, const SyntheticOptions& options);

/// A 640 x 480 camera with about 80 degrees of view and a distortion as real lenses have it.
CameraModel syntheticCamera(DistortionModel distortion);

/// Gaussian vector, standard deviation `sigma` per axis.
Vec3d randomVector(double sigma, std::mt19937_64* rng);

/// exp(noise) * T: standard deviations per axis, world units and radians.
SE3d perturbed(const SE3d& T_a_b, double sigma_translation, double sigma_rad, std::mt19937_64* rng);

/// Size of log(T_b_a * T_truth): (translation, rotation), world units and radians.
double translationError(const SE3d& T_a_b, const SE3d& T_truth);
double rotationError(const SE3d& T_a_b, const SE3d& T_truth);

}  // namespace glide::test
