#pragma once

#include "vit/vit_abi.h"

#include "geometry/lie.h"
#include "image/image.h"

#include "glide/result.h"
#include "glide/types.h"

#include <cstdint>
#include <optional>

namespace glide {

/// A pushed image as grey levels of our own.
struct VitFrame {
  std::int64_t t_ns = 0;
  std::int64_t pushed_ns = 0;  ///< CLOCK_MONOTONIC
  ImageU8 luma;
};

/// Copies L8, and converts R8G8B8 by BT.601; nothing for what we do not read.
std::optional<ImageU8> toLuma(const vit_img_sample& sample);

/// A camera as its runtime describes it.
struct VitCamera {
  CameraIntrinsics intrinsics;
  SE3d T_imu_cam;
};

/// A transform of zeros is the identity. invalid_argument when the numbers are no camera, or the
/// transform is not rigid; unsupported for lens models we lack (RT8 with
/// coefficients beyond the fifth).
Result<VitCamera> toCamera(const vit_camera_calibration& calibration);

}  // namespace glide
