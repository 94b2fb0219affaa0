#pragma once

#include "geometry/eigen_types.h"

#include "glide/result.h"
#include "glide/types.h"

#include <array>
#include <optional>

namespace glide {

/// A projected point with the derivative of the pixel by the camera point.
struct Projection {
  Vec2d uv;
  Mat23d J_uv_point;
};

/// Projection of one camera: pinhole, radial-tangential (4 or 5) or Kannala-Brandt 4. Immutable
/// value. Pixel (0,0) is the centre of the first pixel. Formulas and the reference of each model
/// stand in camera_model.cpp.
class CameraModel {
 public:
  /// invalid_argument naming the field when sizes, focal lengths or coefficient counts are wrong.
  static Result<CameraModel> create(const CameraIntrinsics& intrinsics);

  /// Pixel of a camera point; nothing when the point is behind the camera (pinhole and
  /// radial-tangential: z <= 0), or beyond the radius up to which the distortion is one-to-one.
  /// The pixel may lie outside of the image.
  std::optional<Vec2d> project(const Vec3d& p_cam) const;
  std::optional<Projection> projectWithJacobian(const Vec3d& p_cam) const;

  /// Unit bearing of a pixel (z > 0 except for fisheyes wider than 180 degrees); nothing when the
  /// inverse distortion does not converge.
  std::optional<Vec3d> unproject(const Vec2d& uv) const;

  /// What create() makes this camera from (five coefficients where radial-tangential).
  CameraIntrinsics intrinsics() const;

  /// The same camera for pyramid level l made by decimation: u_l = u_0 / 2^l.
  CameraModel atLevel(int level) const;

  bool isInImage(const Vec2d& uv, double margin_px) const {
    return uv.x() >= margin_px && uv.y() >= margin_px && uv.x() <= width() - 1 - margin_px &&
           uv.y() <= height() - 1 - margin_px;
  }

  DistortionModel distortion() const { return distortion_; }
  int width() const { return width_; }
  int height() const { return height_; }
  double fx() const { return fx_; }
  double fy() const { return fy_; }
  double cx() const { return cx_; }
  double cy() const { return cy_; }
  /// k1, k2, p1, p2, k3 or k1..k4, zero; unused entries are zero.
  const std::array<double, 5>& coefficients() const { return k_; }
  /// Radial-tangential: largest x^2+y^2 (normalised) that is projected. Kannala-Brandt: largest
  /// angle in radians, pi where there is no limit. Infinity for the others where there is none.
  double maxRadius() const { return max_radius_; }

 private:
  CameraModel() = default;
  std::optional<Projection> projectKannalaBrandt(const Vec3d& p_cam) const;

  DistortionModel distortion_ = DistortionModel::none;
  int width_ = 0, height_ = 0;
  double fx_ = 0.0, fy_ = 0.0, cx_ = 0.0, cy_ = 0.0;
  std::array<double, 5> k_{};
  double max_radius_ = 0.0;
};

}  // namespace glide
