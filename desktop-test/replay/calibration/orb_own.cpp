#include "replay/calibration/formats.h"

#include "glide/enum_names.h"

#include <string>
#include <vector>

namespace glide::replay {
namespace {

/// The fields of an ORB-SLAM or stella file, which are written "Camera.fx", "Camera1.fx" or as a
/// map "Camera: {fx: ...}".
class OrbFields {
 public:
  explicit OrbFields(YamlReader& yaml) : yaml_(yaml) {
    const YAML::Node nested = yaml.root()["Camera"];
    is_nested_ = nested.IsDefined() && nested.IsMap();
    map_ = is_nested_ ? nested : yaml.root();
  }

  /// The key under which the file has the field, or would have it.
  std::string key(const std::string& field) const {
    if (is_nested_) return field;
    const std::string numbered = "Camera1." + field;
    return map_[numbered].IsDefined() ? numbered : "Camera." + field;
  }
  bool has(const std::string& field) const { return map_[key(field)].IsDefined(); }
  double number(const std::string& field) { return yaml_.number(map_, key(field)).value_or(0.0); }
  double optionalNumber(const std::string& field) { return has(field) ? number(field) : 0.0; }
  int optionalInteger(const std::string& field) {
    return has(field) ? yaml_.integer(map_, key(field)).value_or(0) : 0;
  }
  std::string optionalText(const std::string& field) {
    return has(field) ? yaml_.text(map_, key(field)).value_or("") : "";
  }
  void fail(const std::string& field, const std::string& message) {
    yaml_.fail(map_[key(field)], key(field), message);
  }

 private:
  YamlReader& yaml_;
  YAML::Node map_;
  bool is_nested_ = false;
};

/// ORB-SLAM3 says Camera.type, stella Camera.model; both may be absent (pinhole).
std::optional<DistortionModel> orbModel(OrbFields& fields) {
  const std::string field = fields.has("type") ? "type" : "model";
  const std::string name = fields.optionalText(field);
  if (name.empty() || name == "PinHole" || name == "Pinhole" || name == "perspective") {
    return DistortionModel::radial_tangential;
  }
  if (name == "KannalaBrandt8" || name == "fisheye") return DistortionModel::kannala_brandt4;
  if (name == "Rectified") return DistortionModel::none;
  fields.fail(field,
              "'" + name +
                  "' is not supported (PinHole, perspective, KannalaBrandt8, "
                  "fisheye, Rectified)");
  return std::nullopt;
}

/// ORB-SLAM's files for cameras with an IMU: an OpenCV matrix of the pose of the camera in the
/// body.
void readOrbExtrinsics(YamlReader& yaml, Calibration& calibration) {
  const YAML::Node root = yaml.root();
  for (const char* key : {"IMU.T_b_c1", "Tbc"}) {
    const YAML::Node matrix = root[key];
    if (!matrix.IsDefined() || !matrix.IsMap()) continue;
    if (const auto data = yaml.numbers(matrix, "data", 16)) {
      calibration.T_body_cam = rigidTransform(yaml, matrix, key, *data);
    }
    return;
  }
}

}  // namespace

Calibration readOrbCalibration(YamlReader& yaml) {
  Calibration calibration;
  CameraIntrinsics& camera = calibration.camera;
  OrbFields fields(yaml);
  const std::optional<DistortionModel> model = orbModel(fields);
  camera.fx = fields.number("fx");
  camera.fy = fields.number("fy");
  camera.cx = fields.number("cx");
  camera.cy = fields.number("cy");
  camera.width = fields.optionalInteger(fields.has("cols") ? "cols" : "width");
  camera.height = fields.optionalInteger(fields.has("rows") ? "rows" : "height");
  if (model == DistortionModel::kannala_brandt4) {
    setDistortion(
        camera,
        *model,
        {fields.number("k1"), fields.number("k2"), fields.number("k3"), fields.number("k4")});
  } else if (model == DistortionModel::radial_tangential) {
    std::vector<double> k = {fields.optionalNumber("k1"),
                             fields.optionalNumber("k2"),
                             fields.optionalNumber("p1"),
                             fields.optionalNumber("p2")};
    const double k3 = fields.optionalNumber("k3");
    if (k3 != 0.0) k.push_back(k3);
    setDistortion(camera, *model, k);
  }
  readOrbExtrinsics(yaml, calibration);
  return calibration;
}

Calibration readOwnCalibration(YamlReader& yaml) {
  Calibration calibration;
  CameraIntrinsics& camera = calibration.camera;
  const YAML::Node map = yaml.root()["camera"];
  camera.fx = yaml.number(map, "fx").value_or(0.0);
  camera.fy = yaml.number(map, "fy").value_or(0.0);
  camera.cx = yaml.number(map, "cx").value_or(0.0);
  camera.cy = yaml.number(map, "cy").value_or(0.0);
  camera.width = yaml.integer(map, "width").value_or(0);
  camera.height = yaml.integer(map, "height").value_or(0);
  const std::string name = yaml.text(map, "distortion").value_or("none");
  const std::optional<DistortionModel> model = enumFromName<DistortionModel>(name);
  if (!model) {
    yaml.fail(map["distortion"],
              "distortion",
              "'" + name + "' is not supported (none, radial_tangential, kannala_brandt4)");
  } else if (*model != DistortionModel::none) {
    const auto coefficients = yaml.numbers(map, "coefficients").value_or(std::vector<double>{});
    const bool may_have_five = *model == DistortionModel::radial_tangential;
    if (coefficients.size() != 4 && !(may_have_five && coefficients.size() == 5)) {
      yaml.fail(map["coefficients"], "coefficients", "do not have the count of " + name);
    }
    setDistortion(camera, *model, coefficients);
  }
  if (!map["T_body_cam"].IsDefined()) return calibration;
  if (const auto data = yaml.numbers(map, "T_body_cam", 16)) {
    calibration.T_body_cam = rigidTransform(yaml, map["T_body_cam"], "T_body_cam", *data);
  }
  return calibration;
}

}  // namespace glide::replay
