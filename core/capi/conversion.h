#pragma once

#include "ar/app_world.h"

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/glide_types.h"
#include "glide/map_view.h"
#include "glide/result.h"

namespace glide {

/// Values between the C++ API and the C ABI, one function for each struct.
Result<Config> toConfig(const glide_config& config);
Result<FrameInput> toFrameInput(const glide_image& image);

glide_pose toC(const SE3d& T);
SE3d fromC(const glide_pose& pose);
/// Whether rotation and translation are finite and the quaternion has length one within a percent.
bool isSound(const glide_pose& pose);

/// `world` turns poses into the app's.
glide_frame toC(const FrameResult& result, const AppWorld& world);
glide_location toC(const LocatedCamera& located, const AppWorld& world);
glide_intrinsics toC(const CameraIntrinsics& camera);
glide_keyframe toC(const MapView::Keyframe& keyframe, const AppWorld& world);
glide_point toC(const MapView::Landmark& landmark, const AppWorld& world);
glide_tracked_point toC(const TrackedPoint& point);

}  // namespace glide
