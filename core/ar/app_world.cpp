#include "ar/app_world.h"

namespace glide {

void AppWorld::level(const SE3d& T_world_cam, const Vec3d& down_cam) {
  const Vec3d down_app = cameraToApp(T_world_cam).q * down_cam.normalized();
  const auto R_level = Eigen::Quaterniond::FromTwoVectors(down_app, Vec3d(-upOf(axes_)));
  R_app_world_ = (R_level * R_app_world_).normalized();
}

void AppWorld::reset() {
  R_app_world_ = appFromCv(axes_);
  scale_ = 1.0;
}

SE3d AppWorld::cameraToApp(const SE3d& T_world_cam) const {
  // The inverse of the half turn on the right: the first camera's quaternion is then 1, not -1.
  return {(R_app_world_ * T_world_cam.q * appFromCv(axes_).conjugate()).normalized(),
          pointToApp(T_world_cam.t)};
}

SE3d AppWorld::cameraToGl(const SE3d& T_world_cam) const {
  const SE3d T_app_cam = cameraToApp(T_world_cam);
  const Eigen::Quaterniond A = appFromCv(AppAxes::gl) * appFromCv(axes_).conjugate();
  return {A * T_app_cam.q * A.conjugate(), A * T_app_cam.t};
}

SE3d AppWorld::cameraFromApp(const SE3d& T_app_cam) const {
  return {(R_app_world_.conjugate() * T_app_cam.q * appFromCv(axes_)).normalized(),
          (R_app_world_.conjugate() * T_app_cam.t) / scale_};
}

SE3d AppWorld::objectToApp(const SE3d& T_world_object) const {
  return {(R_app_world_ * T_world_object.q).normalized(), pointToApp(T_world_object.t)};
}

SE3d AppWorld::objectFromApp(const SE3d& T_app_object) const {
  return {(R_app_world_.conjugate() * T_app_object.q).normalized(),
          (R_app_world_.conjugate() * T_app_object.t) / scale_};
}

}  // namespace glide
