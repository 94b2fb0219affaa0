#include "replay/render/orbit_camera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr double kNear = 0.01, kFar = 100.0;  // in distances: a float depth buffer has room for it
constexpr double kSteep = 0.2;  // sine; a steeper direction turns wildly when seen from above

Matrix4 columnMajor(const Mat4d& matrix) {
  Matrix4 result{};
  Eigen::Map<Eigen::Matrix4f>(result.data()) = matrix.cast<float>();
  return result;
}

/// Unit vector from the eye to the focus.
Vec3d lineOfSight(const Orbit& orbit) {
  const Vec3d level = Eigen::AngleAxisd(orbit.azimuth, orbit.up) * orbit.ahead;
  return std::cos(orbit.elevation) * level - std::sin(orbit.elevation) * orbit.up;
}

Mat4d lookAlong(const Vec3d& forward, const Vec3d& up, const Vec3d& eye) {
  const Vec3d right = forward.cross(up).normalized();
  Mat3d R_eye_world;  // OpenGL's eye: x right, y up, z backward
  R_eye_world << right.transpose(), right.cross(forward).transpose(), -forward.transpose();
  Mat4d T_eye_world = Mat4d::Identity();
  T_eye_world.topLeftCorner<3, 3>() = R_eye_world;
  T_eye_world.topRightCorner<3, 1>() = -R_eye_world * eye;
  return T_eye_world;
}

Mat4d perspective(const Lens& lens, double near, double far) {
  const double focal = 1.0 / std::tan(0.5 * lens.field_of_view);  // of the shorter side
  Mat4d projection = Mat4d::Zero();
  projection(0, 0) = focal / std::max(1.0, lens.aspect);
  projection(1, 1) = focal * std::min(1.0, lens.aspect);
  projection(2, 2) = (far + near) / (near - far);
  projection(2, 3) = 2.0 * far * near / (near - far);
  projection(3, 2) = -1.0;
  return projection;
}

}  // namespace

Vec3d eyeOf(const Orbit& orbit) { return orbit.focus - orbit.distance * lineOfSight(orbit); }

double distanceToSee(const Vec3d& p_world, const Orbit& orbit, double field_of_view) {
  const Vec3d forward = lineOfSight(orbit);
  const Vec3d right = forward.cross(orbit.up).normalized();
  const Vec3d p = p_world - orbit.focus;
  const double aside = std::max(std::abs(p.dot(right)), std::abs(p.dot(right.cross(forward))));
  return aside / std::tan(0.5 * field_of_view) - p.dot(forward);
}

ViewCamera viewOf(const Orbit& orbit, const Lens& lens) {
  const Vec3d forward = lineOfSight(orbit);
  return {columnMajor(lookAlong(forward, orbit.up, eyeOf(orbit))),
          columnMajor(perspective(lens, kNear * orbit.distance, kFar * orbit.distance))};
}

Vec3d levelPart(const Vec3d& direction, const Vec3d& up, const Vec3d& otherwise) {
  const Vec3d level = direction - direction.dot(up) * up;
  return level.norm() < kSteep * direction.norm() ? otherwise : level.normalized();
}

}  // namespace glide::replay
