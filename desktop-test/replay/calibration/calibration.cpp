#include "replay/calibration/calibration.h"

#include "replay/calibration/formats.h"
#include "replay/common/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace glide::replay {
namespace {

constexpr double kRigidTolerance = 1e-3;  // published extrinsics have three to six digits

using Reader = Calibration (*)(YamlReader&);

bool hasPrefix(const std::string& text, const std::string& prefix) {
  return text.rfind(prefix, 0) == 0;
}

/// The format is told by the first key that only one format has.
Reader readerFor(const YAML::Node& root) {
  for (const auto& entry : root) {
    const std::string key = entry.first.as<std::string>("");
    if (key == "camera" && entry.second.IsMap()) return readOwnCalibration;
    if (key == "cam0") return readKalibrCalibration;
    if (key == "intrinsics" || key == "camera_model") return readEurocCalibration;
    if (key == "Camera" || hasPrefix(key, "Camera.") || hasPrefix(key, "Camera1.")) {
      return readOrbCalibration;
    }
  }
  return nullptr;
}

/// A broken field would otherwise surface only as a refusal of the whole camera.
std::optional<std::string> implausible(const CameraIntrinsics& camera) {
  if (!(camera.fx > 0.0)) return "the focal length fx must be positive";
  if (!(camera.fy > 0.0)) return "the focal length fy must be positive";
  if (camera.width < 0 || camera.height < 0) return "the image size must be positive";
  return std::nullopt;
}

}  // namespace

void setDistortion(CameraIntrinsics& camera,
                   DistortionModel model,
                   const std::vector<double>& coefficients) {
  const bool is_zero =
      std::all_of(coefficients.begin(), coefficients.end(), [](double k) { return k == 0.0; });
  // A fisheye without coefficients is still equidistant, not a pinhole.
  const bool is_pinhole =
      model == DistortionModel::none || (model == DistortionModel::radial_tangential && is_zero);
  camera.distortion = is_pinhole ? DistortionModel::none : model;
  camera.coefficients = is_pinhole ? std::vector<double>{} : coefficients;
}

std::optional<SE3d> rigidTransform(YamlReader& yaml,
                                   const YAML::Node& map,
                                   const std::string& key,
                                   const std::vector<double>& row_major) {
  const Mat4d T = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(row_major.data());
  const Mat3d R = T.topLeftCorner<3, 3>();
  const bool is_rigid = (R.transpose() * R - Mat3d::Identity()).norm() < kRigidTolerance &&
                        R.determinant() > 0.0 &&
                        (T.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kRigidTolerance;
  if (!is_rigid) {
    yaml.fail(map, key, "is not a rigid transform (rotation matrix, translation, 0 0 0 1)");
    return std::nullopt;
  }
  return SE3d{Eigen::Quaterniond(R).normalized(), T.topRightCorner<3, 1>()};
}

Result<Calibration> loadCalibration(const std::string& file_or_preset) {
  if (const auto preset = calibrationPreset(file_or_preset)) return *preset;
  if (!std::filesystem::exists(file_or_preset)) {
    return errorIn(file_or_preset,
                   "is neither a calibration file, nor a preset (freiburg1, freiburg2, freiburg3), "
                   "nor a field of view (fov:69)");
  }
  Result<YamlReader> yaml = YamlReader::open(file_or_preset);
  if (!yaml) return yaml.error();
  const Reader read = readerFor(yaml->root());
  if (read == nullptr) {
    return errorIn(file_or_preset,
                   "is no calibration: expected the fields of EuRoC (intrinsics), Kalibr (cam0), "
                   "ORB-SLAM or stella (Camera.fx) or camera: (docs/calibration.md)");
  }
  Calibration calibration = read(*yaml);
  if (yaml->error()) return *yaml->error();
  if (const auto fault = implausible(calibration.camera)) return errorIn(file_or_preset, *fault);
  calibration.origin = file_or_preset;
  return calibration;
}

std::optional<Calibration> calibrationPreset(const std::string& name) {
  // "Camera Calibration", https://cvg.cit.tum.de/data/datasets/rgbd-dataset/file_formats. The
  // images of freiburg3 were undistorted by their authors.
  Calibration calibration;
  CameraIntrinsics& camera = calibration.camera;
  if (name == "freiburg1") {
    camera = {640, 480, 517.3, 516.5, 318.6, 255.3, {}, {}};
    setDistortion(
        camera, DistortionModel::radial_tangential, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633});
  } else if (name == "freiburg2") {
    camera = {640, 480, 520.9, 521.0, 325.1, 249.7, {}, {}};
    setDistortion(
        camera, DistortionModel::radial_tangential, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172});
  } else if (name == "freiburg3") {
    camera = {640, 480, 535.4, 539.2, 320.1, 247.6, {}, {}};
  } else {
    return std::nullopt;
  }
  calibration.origin = "preset " + name;
  return calibration;
}

}  // namespace glide::replay
