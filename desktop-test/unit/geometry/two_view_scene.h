#pragma once

#include "unit/geometry/random_geometry.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "geometry/ray_pair.h"
#include "geometry/two_view.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace glide::test {

enum class SceneShape { box, plane };

/// Points seen by camera a at 2.5 to 6 units (box) or on a slanted plane about 4 units away.
struct SceneOptions {
  SceneShape shape = SceneShape::box;
  SE3d T_b_a{so3Exp(Vec3d(0.02, -0.06, 0.01)), Vec3d(-0.4, 0.05, 0.02)};
  int pairs = 300;
  double noise_px = 0.0;
  double outlier_share = 0.0;
  unsigned seed = 1;
};

struct Scene {
  SE3d T_b_a;
  std::vector<Vec3d> points_a;
  std::vector<PixelPair> pairs;
  std::vector<bool> outlier;
};

inline CameraModel euroc() {
  return CameraModel::create({752,
                              480,
                              458.654,
                              457.296,
                              367.215,
                              248.375,
                              DistortionModel::radial_tangential,
                              {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05}})
      .value();
}

/// The camera of desk_fisheye_400.
inline CameraModel fisheye() {
  return CameraModel::create({320,
                              240,
                              192.49339078,
                              193.60543407,
                              162.0,
                              125.0,
                              DistortionModel::kannala_brandt4,
                              {-0.00233426, -0.07807222, 0.08845117, -0.03281482}})
      .value();
}

inline Vec2d randomPixel(const CameraModel& camera, RandomGeometry& random) {
  return {random.uniform(0.0, camera.width() - 1), random.uniform(0.0, camera.height() - 1)};
}

/// Depth along a bearing of a point of the shape.
inline double depthOf(SceneShape shape, const Vec3d& bearing, RandomGeometry& random) {
  if (shape == SceneShape::box) return random.uniform(2.5, 6.0);
  const Vec3d normal = Vec3d(0.3, 0.2, 1.0).normalized();
  return 4.0 / normal.dot(bearing);
}

inline Scene makeScene(const CameraModel& camera, const SceneOptions& options) {
  RandomGeometry random(options.seed);
  Scene scene;
  scene.T_b_a = options.T_b_a;
  while (static_cast<int>(scene.pairs.size()) < options.pairs) {
    const Vec2d uv_a = randomPixel(camera, random);
    const std::optional<Vec3d> bearing = camera.unproject(uv_a);
    if (!bearing) continue;
    const Vec3d p_a = *bearing * depthOf(options.shape, *bearing, random);
    const std::optional<Vec2d> uv_b = camera.project(options.T_b_a * p_a);
    if (!uv_b || !camera.isInImage(*uv_b, 0.0)) continue;
    const auto noise = [&] {
      return Vec2d(random.gauss(options.noise_px), random.gauss(options.noise_px));
    };
    const bool outlier = random.uniform(0.0, 1.0) < options.outlier_share;
    scene.points_a.push_back(p_a);
    scene.outlier.push_back(outlier);
    scene.pairs.push_back(
        {uv_a + noise(), outlier ? randomPixel(camera, random) : *uv_b + noise()});
  }
  return scene;
}

/// Angle between two rotations, and between two translations, radians.
inline double rotationError(const SE3d& T, const SE3d& T_truth) {
  return so3Log(T.q * T_truth.q.conjugate()).norm();
}
inline double directionError(const SE3d& T, const SE3d& T_truth) {
  return std::atan2(T.t.cross(T_truth.t).norm(), T.t.dot(T_truth.t));
}

}  // namespace glide::test
