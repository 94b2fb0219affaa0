#pragma once

#include "geometry/camera_model.h"

namespace glide {

/// The screen that an app draws on.
struct Display {
  int rotation_deg = 0;  ///< by how much the image is turned clockwise to be upright: 0 90 180 270
  int width = 0, height = 0;  ///< px; 0: as the image
};

/// What a projection needs besides the camera.
struct ClipPlanes {
  double near = 0.0, far = 0.0;  ///< scene units, 0 < near < far
};

/// OpenGL's projection of the pinhole part of `camera` onto the display, which the image fills: it
/// is cropped about its centre. For cameras that look along -z, y up, turned as viewRotation says.
Mat4d projectionMatrix(const CameraModel& camera, const Display& display, const ClipPlanes& planes);

/// Rotation from the camera (GL axes) to the display-oriented camera.
Mat3d viewRotation(const Display& display);

}  // namespace glide
