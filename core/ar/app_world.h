#pragma once

#include "ar/axes.h"

namespace glide {

/// The world as the app sees it: the map's world in the app's axes, turned upright and scaled. A
/// value; its owner says who may touch it.
///   p_app = scale * R_app_world * p_world,  R_app_cam = R_app_world * R_world_cam * A
/// where A turns the camera's own axes (ar/axes.h).
class AppWorld {
 public:
  explicit AppWorld(AppAxes axes) : axes_(axes), R_app_world_(appFromCv(axes)) {}

  /// Lengths shown from now on are `factor` times those shown now.
  void scaleBy(double factor) { scale_ *= factor; }
  /// Turns the world about its origin, as little as possible, until `down_cam`, a direction in the
  /// axes of the app's camera at `T_world_cam`, points down. `down_cam` is not zero.
  void level(const SE3d& T_world_cam, const Vec3d& down_cam);
  /// Arbitrary scale and the first camera's attitude again, as for a new map.
  void reset();

  /// A camera (or any frame with camera axes) of the map's world, in the app's, and back.
  SE3d cameraToApp(const SE3d& T_world_cam) const;
  /// The same with OpenGL's axes, of world and camera, whatever the app's are.
  SE3d cameraToGl(const SE3d& T_world_cam) const;
  SE3d cameraFromApp(const SE3d& T_app_cam) const;
  /// A frame whose own axes are the app's affair, such as an anchor.
  SE3d objectToApp(const SE3d& T_world_object) const;
  SE3d objectFromApp(const SE3d& T_app_object) const;
  Vec3d pointToApp(const Vec3d& p_world) const { return scale_ * (R_app_world_ * p_world); }

  double scale() const { return scale_; }

 private:
  AppAxes axes_;
  Eigen::Quaterniond R_app_world_;
  double scale_ = 1.0;
};

}  // namespace glide
