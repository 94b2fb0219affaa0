#pragma once

#include "vit/vit_abi.h"

#include "geometry/lie.h"

#include "glide/map_view.h"
#include "glide/types.h"

#include <vector>

namespace glide {

/// The landmarks that the camera has in view, with their pixels and depths. `map` is the one that
/// T_cam_world is of, and its corrected camera, when it has one, takes the place of `given`: the
/// pose is of that camera.
std::vector<vit_pose_feature> visibleFeatures(const MapView& map,
                                              const CameraIntrinsics& given,
                                              const SE3d& T_cam_world);

}  // namespace glide
