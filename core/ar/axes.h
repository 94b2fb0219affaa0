#pragma once

#include "geometry/lie.h"

namespace glide {

/// Axes of the poses and points that an app sees. The library works in OpenCV's.
enum class AppAxes {
  gl,  ///< x right, y up, cameras look along -z (OpenGL, ARCore, OpenXR)
  cv,  ///< x right, y down, cameras look along +z (OpenCV)
};

/// The one place where axes are converted: turns OpenCV axes into the app's, and back, as it is its
/// own inverse (half a turn about x, or nothing).
inline Eigen::Quaterniond appFromCv(AppAxes axes) {
  return axes == AppAxes::gl ? Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0)
                             : Eigen::Quaterniond::Identity();
}

/// The world's up in the app's axes.
inline Vec3d upOf(AppAxes axes) { return {0.0, axes == AppAxes::gl ? 1.0 : -1.0, 0.0}; }

}  // namespace glide
