#pragma once

#include "support/golden_image.h"

#include "geometry/lie.h"

#include "glide/camera_renderer.h"
#include "glide/render_target.h"

#include <functional>
#include <vector>

namespace glide::test {

/// A lens of that size: a pinhole, a wide one with barrel distortion, or a fisheye.
CameraIntrinsics pinhole(int width, int height);
CameraIntrinsics barrel(int width, int height);
CameraIntrinsics fisheye(int width, int height);

/// Camera at `eye` that looks at `target`, upright (y down).
Pose lookAt(const Vec3d& eye, const Vec3d& target);

/// A room's corner in grey as that camera sees it: a floor of tiles at y = 0 and a plain wall.
struct GreyPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  Luma luma() const { return {pixels.data(), width, height, width}; }
};
GreyPicture tiledFloor(const CameraIntrinsics& camera, const Pose& T_world_cam);

/// Points in a grid with residuals from 0 to the end of the scale, every seventh an outlier, moved
/// along by `frame` frames.
std::vector<TrackedPoint> gridOfPoints(const CameraIntrinsics& camera, int frame);

/// What `draw` leaves in a target of that size, on grey.
RgbPicture drawn(int width, int height, const std::function<void(const Viewport&)>& draw);

}  // namespace glide::test
