#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include "glide/map_view.h"

#include <vector>

namespace glide {

/// A landmark that the camera has in view.
struct VisiblePoint {
  std::size_t index = 0;  ///< into MapView::landmarks
  Vec3d p_cam;
  Vec2d uv;  ///< px
};

/// The landmarks in front of the camera whose projections lie in the image. Occlusion is not known.
std::vector<VisiblePoint> visiblePoints(const MapView& map,
                                        const CameraModel& camera,
                                        const SE3d& T_cam_world);

/// What a ray through a pixel meets.
struct SurfaceHit {
  SE3d T_cam_hit;         ///< at the hit; its -y axis (OpenCV axes: up) along the surface's normal
  double distance = 0.0;  ///< from the camera
  int points = 0;         ///< landmarks that the surface rests on; 1: a single point
};

/// The local plane through the landmarks around the pixel, when there is one, and the landmark
/// nearest to the pixel; nearest hit first. A plane faces the camera; the normal of a single point
/// points to it. Empty when no landmark is near.
std::vector<SurfaceHit> hitTest(const std::vector<VisiblePoint>& visible,
                                const CameraModel& camera,
                                const Vec2d& uv);

}  // namespace glide
