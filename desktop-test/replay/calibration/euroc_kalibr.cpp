#include "replay/calibration/formats.h"

#include <string>
#include <vector>

namespace glide::replay {
namespace {

/// A distortion model's names in EuRoC's and Kalibr's files.
struct ModelName {
  const char* name;
  DistortionModel model;
};

constexpr ModelName kModels[] = {{"radial-tangential", DistortionModel::radial_tangential},
                                 {"radtan", DistortionModel::radial_tangential},
                                 {"plumb_bob", DistortionModel::radial_tangential},
                                 {"equidistant", DistortionModel::kannala_brandt4},
                                 {"kannala-brandt", DistortionModel::kannala_brandt4},
                                 {"none", DistortionModel::none}};

constexpr std::size_t kKannalaBrandtCount = 4;

void readIntrinsics(YamlReader& yaml, const YAML::Node& map, CameraIntrinsics& camera) {
  const auto model = yaml.text(map, "camera_model");
  if (model && *model != "pinhole") {
    yaml.fail(map["camera_model"],
              "camera_model",
              "'" + *model + "' is not supported (only pinhole with a distortion model)");
  }
  if (const auto focal = yaml.numbers(map, "intrinsics", 4)) {
    camera.fx = (*focal)[0];
    camera.fy = (*focal)[1];
    camera.cx = (*focal)[2];
    camera.cy = (*focal)[3];
  }
  if (const auto size = yaml.numbers(map, "resolution", 2)) {
    camera.width = static_cast<int>((*size)[0]);
    camera.height = static_cast<int>((*size)[1]);
  }
}

bool isCountRight(DistortionModel model, std::size_t count) {
  if (model == DistortionModel::radial_tangential) return count == 4 || count == 5;
  return count == kKannalaBrandtCount;
}

/// EuRoC and Kalibr differ in the name of the coefficients only.
void readDistortion(YamlReader& yaml,
                    const YAML::Node& map,
                    const std::string& coefficients_key,
                    CameraIntrinsics& camera) {
  const auto name = yaml.text(map, "distortion_model");
  if (!name) return;
  const ModelName* found = nullptr;
  for (const ModelName& candidate : kModels) {
    if (*name == candidate.name) found = &candidate;
  }
  if (found == nullptr) {
    yaml.fail(map["distortion_model"],
              "distortion_model",
              "'" + *name + "' is not supported (radial-tangential, radtan, equidistant, none)");
    return;
  }
  if (found->model == DistortionModel::none) return;
  const auto coefficients = yaml.numbers(map, coefficients_key);
  if (!coefficients) return;
  if (!isCountRight(found->model, coefficients->size())) {
    yaml.fail(map[coefficients_key],
              coefficients_key,
              "has " + std::to_string(coefficients->size()) + " numbers, which " + *name +
                  " does not take");
    return;
  }
  setDistortion(camera, found->model, *coefficients);
}

}  // namespace

Calibration readEurocCalibration(YamlReader& yaml) {
  Calibration calibration;
  const YAML::Node root = yaml.root();
  readIntrinsics(yaml, root, calibration.camera);
  readDistortion(yaml, root, "distortion_coefficients", calibration.camera);
  const YAML::Node extrinsics = root["T_BS"];
  if (!extrinsics.IsDefined()) return calibration;
  if (!extrinsics.IsMap()) {
    yaml.fail(extrinsics, "T_BS", "must be a map with data: [16 numbers]");
    return calibration;
  }
  if (const auto data = yaml.numbers(extrinsics, "data", 16)) {
    calibration.T_body_cam = rigidTransform(yaml, extrinsics, "T_BS", *data);
  }
  return calibration;
}

Calibration readKalibrCalibration(YamlReader& yaml) {
  Calibration calibration;
  const YAML::Node cam0 = yaml.root()["cam0"];
  if (!cam0.IsMap()) {
    yaml.fail(cam0, "cam0", "must be a map of fields");
    return calibration;
  }
  readIntrinsics(yaml, cam0, calibration.camera);
  readDistortion(yaml, cam0, "distortion_coeffs", calibration.camera);
  const YAML::Node rows = cam0["T_cam_imu"];
  if (!rows.IsDefined()) return calibration;
  std::vector<double> values;
  for (const YAML::Node& row : rows) {
    for (const YAML::Node& item : row) {
      if (const auto value = asNumber(item)) values.push_back(*value);
    }
  }
  if (values.size() != 16) {
    yaml.fail(rows, "T_cam_imu", "must be four rows of four numbers");
    return calibration;
  }
  const auto T_cam_body = rigidTransform(yaml, rows, "T_cam_imu", values);
  if (T_cam_body) calibration.T_body_cam = T_cam_body->inverse();
  return calibration;
}

}  // namespace glide::replay
