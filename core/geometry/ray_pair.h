#pragma once

#include "geometry/camera_model.h"
#include "geometry/two_view.h"

#include <cstddef>
#include <span>
#include <vector>

namespace glide {

using Mat32d = Eigen::Matrix<double, 3, 2>;

/// One pixel as a unit bearing with its link to pixels: every error in this folder's two-view code
/// is in pixels to first order, whatever the lens.
struct Ray {
  Vec3d f;                ///< unit bearing
  Mat23d J_uv_bearing;    ///< pixel by bearing; J * f = 0
  Mat32d J_bearing_uv;    ///< bearing by pixel; perpendicular to f
  double px_per_rad = 0;  ///< mean local focal length
};

/// A correspondence as rays.
struct RayPair {
  Ray a, b;
  std::size_t index = 0;  ///< of the PixelPair it was made from
};

/// The pairs whose two pixels can be unprojected.
std::vector<RayPair> makeRayPairs(const CameraModel& camera, std::span<const PixelPair> pairs);

}  // namespace glide
