#pragma once

#include "geometry/lie.h"

#include "glide/result.h"
#include "glide/types.h"

#include <optional>
#include <string>

namespace glide::replay {

/// What a calibration file says about one camera.
struct Calibration {
  CameraIntrinsics camera;         ///< width and height are 0 when the file does not tell them
  std::optional<SE3d> T_body_cam;  ///< metres; EuRoC's T_BS
  std::string origin;              ///< file or preset, for messages
};

/// Loads a calibration from what -c names: a preset (freiburg1, freiburg2, freiburg3) or a file in
/// one of the formats of docs/calibration.md, told by its keys. io naming file, line and field.
Result<Calibration> loadCalibration(const std::string& file_or_preset);

/// The published calibrations of the TUM RGB-D cameras; nothing for another name.
std::optional<Calibration> calibrationPreset(const std::string& name);

}  // namespace glide::replay
