#include "ar/display.h"

namespace glide {
namespace {

/// Turns x, y clockwise by the display's rotation, exactly.
Mat3d turn(int rotation_deg) {
  constexpr double kCos[] = {1.0, 0.0, -1.0, 0.0};
  constexpr double kSin[] = {0.0, 1.0, 0.0, -1.0};
  const auto quarter = static_cast<std::size_t>(rotation_deg / 90);
  Mat3d R = Mat3d::Identity();
  R(0, 0) = R(1, 1) = kCos[quarter];
  R(0, 1) = kSin[quarter];
  R(1, 0) = -kSin[quarter];
  return R;
}

Mat4d homogeneous(const Mat3d& R) {
  Mat4d T = Mat4d::Identity();
  T.topLeftCorner<3, 3>() = R;
  return T;
}

/// Projection onto the whole image, unturned. Pixel (0,0) is the centre of the first pixel: the
/// image begins half a pixel before it.
Mat4d imageProjection(const CameraModel& camera, const ClipPlanes& planes) {
  const double depth = planes.far - planes.near;
  Mat4d P = Mat4d::Zero();
  P(0, 0) = 2.0 * camera.fx() / camera.width();
  P(0, 2) = 1.0 - 2.0 * (camera.cx() + 0.5) / camera.width();
  P(1, 1) = 2.0 * camera.fy() / camera.height();
  P(1, 2) = 2.0 * (camera.cy() + 0.5) / camera.height() - 1.0;
  P(2, 2) = -(planes.far + planes.near) / depth;
  P(2, 3) = -2.0 * planes.far * planes.near / depth;
  P(3, 2) = -1.0;
  return P;
}

}  // namespace

Mat3d viewRotation(const Display& display) { return turn(display.rotation_deg); }

Mat4d projectionMatrix(const CameraModel& camera,
                       const Display& display,
                       const ClipPlanes& planes) {
  const Mat4d R = homogeneous(viewRotation(display));
  Mat4d P = R * imageProjection(camera, planes) * R.transpose();
  if (display.width <= 0 || display.height <= 0) return P;
  const bool is_upright = display.rotation_deg % 180 == 0;
  const double image_aspect = is_upright ? static_cast<double>(camera.width()) / camera.height()
                                         : static_cast<double>(camera.height()) / camera.width();
  const double display_aspect = static_cast<double>(display.width) / display.height;
  if (image_aspect > display_aspect) {
    P.row(0) *= image_aspect / display_aspect;
  } else {
    P.row(1) *= display_aspect / image_aspect;
  }
  return P;
}

}  // namespace glide
