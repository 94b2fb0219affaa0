#pragma once

#include "replay/calibration/calibration.h"
#include "replay/common/yaml_reader.h"

namespace glide::replay {

/// The formats of docs/calibration.md. Each reads the document of `yaml`; faults are left in
/// yaml.error(), and the result counts only when there is none.
Calibration readEurocCalibration(YamlReader& yaml);
Calibration readKalibrCalibration(YamlReader& yaml);
Calibration readOrbCalibration(YamlReader& yaml);
Calibration readOwnCalibration(YamlReader& yaml);

/// Puts coefficients into the camera; when all are zero the model becomes none.
void setDistortion(CameraIntrinsics& camera,
                   DistortionModel model,
                   const std::vector<double>& coefficients);

/// A row-major 4x4 rigid transform; a fault names `key` when it is none.
std::optional<SE3d> rigidTransform(YamlReader& yaml,
                                   const YAML::Node& map,
                                   const std::string& key,
                                   const std::vector<double>& row_major);

}  // namespace glide::replay
