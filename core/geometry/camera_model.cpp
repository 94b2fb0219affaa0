// Formulas, with x = X/Z, y = Y/Z of the camera point:
//   radial-tangential (Brown 1971, OpenCV's order of coefficients), r2 = x^2 + y^2:
//     g = 1 + k1 r2 + k2 r2^2 + k3 r2^3
//     x_d = x g + 2 p1 x y + p2 (r2 + 2 x^2)
//     y_d = y g + p1 (r2 + 2 y^2) + 2 p2 x y
//   Kannala-Brandt 4 (Kannala and Brandt, PAMI 2006, as OpenCV's fisheye):
//     r = |(X, Y)|, theta = atan2(r, Z)
//     theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
//     (x_d, y_d) = theta_d (X, Y) / r
//   pixel: u = fx x_d + cx, v = fy y_d + cy.
#include "geometry/camera_model.h"

#include "geometry/distortion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace glide {
namespace {

Error invalid(const std::string& message) { return {ErrorCode::invalid_argument, message}; }

std::optional<Error> checkCoefficients(const CameraIntrinsics& intrinsics) {
  const std::size_t count = intrinsics.coefficients.size();
  const char* wanted = nullptr;
  switch (intrinsics.distortion) {
    case DistortionModel::none:
      wanted = count == 0 ? nullptr : "0 for no distortion";
      break;
    case DistortionModel::radial_tangential:
      wanted = count == 4 || count == 5 ? nullptr : "4 or 5 for radial_tangential";
      break;
    case DistortionModel::kannala_brandt4:
      wanted = count == 4 ? nullptr : "4 for kannala_brandt4";
      break;
  }
  if (wanted) {
    return invalid("camera.coefficients: " + std::to_string(count) + " given, must be " + wanted);
  }
  for (const double k : intrinsics.coefficients) {
    if (!std::isfinite(k)) return invalid("camera.coefficients: must be finite");
  }
  return std::nullopt;
}

/// Whether a principal point can be right: a crop's may lie outside of it, but not far.
bool isNearImage(double center, int size) { return center >= -size && center <= 2.0 * size; }

std::optional<Error> checkIntrinsics(const CameraIntrinsics& intrinsics) {
  if (intrinsics.width <= 0) return invalid("camera.width: must be positive");
  if (intrinsics.height <= 0) return invalid("camera.height: must be positive");
  if (!(std::isfinite(intrinsics.fx) && intrinsics.fx > 0.0)) {
    return invalid("camera.fx: must be positive");
  }
  if (!(std::isfinite(intrinsics.fy) && intrinsics.fy > 0.0)) {
    return invalid("camera.fy: must be positive");
  }
  if (!isNearImage(intrinsics.cx, intrinsics.width))
    return invalid("camera.cx: must be within one width of the image");
  if (!isNearImage(intrinsics.cy, intrinsics.height))
    return invalid("camera.cy: must be within one height of the image");
  return checkCoefficients(intrinsics);
}

}  // namespace

Result<CameraModel> CameraModel::create(const CameraIntrinsics& intrinsics) {
  if (std::optional<Error> error = checkIntrinsics(intrinsics)) return *std::move(error);
  CameraModel camera;
  camera.distortion_ = intrinsics.distortion;
  camera.width_ = intrinsics.width;
  camera.height_ = intrinsics.height;
  camera.fx_ = intrinsics.fx;
  camera.fy_ = intrinsics.fy;
  camera.cx_ = intrinsics.cx;
  camera.cy_ = intrinsics.cy;
  std::copy(intrinsics.coefficients.begin(), intrinsics.coefficients.end(), camera.k_.begin());
  camera.max_radius_ = monotonicLimit(camera.distortion_, camera.k_);
  return camera;
}

std::optional<Vec2d> CameraModel::project(const Vec3d& p_cam) const {
  if (distortion_ == DistortionModel::kannala_brandt4) {
    const double r = std::sqrt(p_cam.x() * p_cam.x() + p_cam.y() * p_cam.y());
    const double theta = std::atan2(r, p_cam.z());
    if (!(theta <= max_radius_) || (r == 0.0 && !(p_cam.z() > 0.0))) return std::nullopt;
    const double scale = r > 0.0 ? kannalaBrandt(k_, theta) / r : 1.0 / p_cam.z();
    return Vec2d(fx_ * scale * p_cam.x() + cx_, fy_ * scale * p_cam.y() + cy_);
  }
  if (!(p_cam.z() > 0.0)) return std::nullopt;
  Vec2d xy = p_cam.head<2>() / p_cam.z();
  const double r2 = xy.squaredNorm();
  if (!(r2 <= max_radius_ && r2 < kMaxTangentSquared)) return std::nullopt;
  if (distortion_ == DistortionModel::radial_tangential) xy = distortRadialTangential(k_, xy);
  return Vec2d(fx_ * xy.x() + cx_, fy_ * xy.y() + cy_);
}

std::optional<Projection> CameraModel::projectWithJacobian(const Vec3d& p_cam) const {
  if (distortion_ == DistortionModel::kannala_brandt4) return projectKannalaBrandt(p_cam);
  if (!(p_cam.z() > 0.0)) return std::nullopt;
  const double inverse_z = 1.0 / p_cam.z();
  const Vec2d xy = p_cam.head<2>() * inverse_z;
  const double r2 = xy.squaredNorm();
  if (!(r2 <= max_radius_ && r2 < kMaxTangentSquared)) return std::nullopt;

  DistortedPoint distorted{xy, Mat2d::Identity()};
  if (distortion_ == DistortionModel::radial_tangential) distorted = distortWithJacobian(k_, xy);
  Projection out;
  out.uv = Vec2d(fx_ * distorted.xy.x() + cx_, fy_ * distorted.xy.y() + cy_);
  Mat2d J = distorted.J_distorted_xy * inverse_z;
  J.row(0) *= fx_;
  J.row(1) *= fy_;
  out.J_uv_point << J, -J * xy;
  return out;
}

std::optional<Projection> CameraModel::projectKannalaBrandt(const Vec3d& p_cam) const {
  const double x = p_cam.x();
  const double y = p_cam.y();
  const double z = p_cam.z();
  const double r2 = x * x + y * y;
  const double r = std::sqrt(r2);
  const double theta = std::atan2(r, z);
  if (!(theta <= max_radius_) || (r == 0.0 && !(z > 0.0))) return std::nullopt;

  // scale = theta_d / r; its derivative by (X, Y) is along (X, Y), on the axis it is zero.
  const double slope = kannalaBrandtDerivative(k_, theta) / (r2 + z * z);
  const double scale = r > 0.0 ? kannalaBrandt(k_, theta) / r : 1.0 / z;
  const double bend = r > 0.0 ? (slope * z - scale) / r2 : 0.0;
  Projection out;
  out.uv = Vec2d(fx_ * scale * x + cx_, fy_ * scale * y + cy_);
  out.J_uv_point << fx_ * (scale + bend * x * x), fx_ * bend * x * y, -fx_ * slope * x,  //
      fy_ * bend * x * y, fy_ * (scale + bend * y * y), -fy_ * slope * y;
  return out;
}

std::optional<Vec3d> CameraModel::unproject(const Vec2d& uv) const {
  const Vec2d target((uv.x() - cx_) / fx_, (uv.y() - cy_) / fy_);
  switch (distortion_) {
    case DistortionModel::radial_tangential:
      return unprojectRadialTangential(k_, target, max_radius_);
    case DistortionModel::kannala_brandt4:
      return unprojectKannalaBrandt(k_, target, max_radius_);
    case DistortionModel::none:
      break;
  }
  return Vec3d(target.x(), target.y(), 1.0).normalized();
}

CameraIntrinsics CameraModel::intrinsics() const {
  CameraIntrinsics intrinsics{width_, height_, fx_, fy_, cx_, cy_, distortion_, {}};
  switch (distortion_) {
    case DistortionModel::radial_tangential:
      intrinsics.coefficients.assign(k_.begin(), k_.end());
      break;
    case DistortionModel::kannala_brandt4:
      intrinsics.coefficients.assign(k_.begin(), k_.end() - 1);
      break;
    case DistortionModel::none:
      break;
  }
  return intrinsics;
}

CameraModel CameraModel::atLevel(int level) const {
  assert(level >= 0);
  CameraModel scaled = *this;
  const double factor = std::ldexp(1.0, -level);
  scaled.fx_ *= factor;
  scaled.fy_ *= factor;
  scaled.cx_ *= factor;
  scaled.cy_ *= factor;
  for (int i = 0; i < level; ++i) {
    scaled.width_ = (scaled.width_ + 1) / 2;
    scaled.height_ = (scaled.height_ + 1) / 2;
  }
  return scaled;
}

}  // namespace glide
