#include "render/camera_scene.h"

#include "geometry/camera_model.h"
#include "geometry/pose_conversion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::test {
namespace {

constexpr double kTile = 0.1;
constexpr double kWall_z = 0.8;

/// Grey level of what a ray from `eye` meets.
double greyAlong(const Vec3d& eye, const Vec3d& ray) {
  const double to_wall = (kWall_z - eye.z()) / ray.z();
  const double to_floor = -eye.y() / ray.y();
  if (ray.y() <= 0.0 || (ray.z() > 0.0 && to_wall < to_floor)) return ray.z() > 0.0 ? 150.0 : 60.0;
  const Vec3d hit = eye + to_floor * ray;
  const auto tile = static_cast<int>(std::floor(hit.x() / kTile) + std::floor(hit.z() / kTile));
  return tile % 2 == 0 ? 120.0 : 95.0;
}

}  // namespace

CameraIntrinsics pinhole(int width, int height) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 0.8 * width;
  camera.cx = 0.5 * width - 0.5;
  camera.cy = 0.5 * height - 0.5;
  return camera;
}

CameraIntrinsics barrel(int width, int height) {
  CameraIntrinsics camera = pinhole(width, height);
  camera.fx = camera.fy = 0.6 * width;
  camera.distortion = DistortionModel::radial_tangential;
  camera.coefficients = {-0.28, 0.07, 0.0002, 0.0, 0.0};
  return camera;
}

CameraIntrinsics fisheye(int width, int height) {
  CameraIntrinsics camera = pinhole(width, height);
  camera.fx = camera.fy = 0.33 * width;
  camera.distortion = DistortionModel::kannala_brandt4;
  camera.coefficients = {0.01, -0.005, 0.002, -0.0005};
  return camera;
}

Pose lookAt(const Vec3d& eye, const Vec3d& target) {
  Mat3d axes;
  axes.col(2) = (target - eye).normalized();
  axes.col(0) = Vec3d::UnitY().cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return toPose({Eigen::Quaterniond(axes), eye});
}

GreyPicture tiledFloor(const CameraIntrinsics& camera, const Pose& T_world_cam) {
  const Result<CameraModel> model = CameraModel::create(camera);
  const SE3d T = fromPose(T_world_cam);
  GreyPicture picture{camera.width, camera.height, {}};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto ray = model->unproject(Vec2d(x, y));
      const double grey = ray ? greyAlong(T.t, T.q * *ray) : 0.0;
      picture.pixels.push_back(static_cast<std::uint8_t>(grey));
    }
  }
  return picture;
}

std::vector<TrackedPoint> gridOfPoints(const CameraIntrinsics& camera, int frame) {
  constexpr int kColumns = 9, kRows = 6;
  constexpr float kScale = 3.0F;  // px, of the indirect tracker
  std::vector<TrackedPoint> points;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const float x = static_cast<float>(i % kColumns + 1) / (kColumns + 1);
    const float y = static_cast<float>(i / kColumns + 1) / (kRows + 1);
    const float speed = 3.0F * (x - 0.5F);
    TrackedPoint point;
    point.landmark = static_cast<std::uint64_t>(i + 1);
    point.u = x * static_cast<float>(camera.width) + speed * static_cast<float>(frame);
    point.v = y * static_cast<float>(camera.height) + 1.5F * static_cast<float>(frame);
    point.residual = kScale * static_cast<float>(i) / (kColumns * kRows);
    point.inlier = i % 7 != 3;
    points.push_back(point);
  }
  return points;
}

RgbPicture drawn(int width, int height, const std::function<void(const Viewport&)>& draw) {
  Result<RenderTarget> target = RenderTarget::create(width, height);
  EXPECT_TRUE(target.ok()) << target.error().message;
  if (!target) return {};
  EXPECT_TRUE(target->begin({0.2F, 0.2F, 0.2F, 1.0F}).ok());
  draw({0, 0, width, height});
  return {width, height, target->readRgb()};
}

}  // namespace glide::test
