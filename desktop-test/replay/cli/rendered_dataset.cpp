#include "replay/cli/rendered_dataset.h"

#include "replay/common/text.h"
#include "replay/evaluation/trajectory.h"
#include "support/textured_scene.h"

#include "geometry/camera_model.h"

#include <opencv2/imgcodecs.hpp>

#include <string>

namespace glide::replay {
namespace {

constexpr const char* kCalibration =
    "camera:\n  width: 320\n  height: 240\n  fx: 260\n  fy: 260\n  cx: 159.5\n  cy: 119.5\n"
    "  distortion: none\n";
constexpr double kStep = 0.015;                 // m per frame, at 1 m to 1.5 m distance
constexpr std::int64_t kPeriodNs = 33'333'333;  // 30 Hz

/// Relief all over the view: a plane alone has two explanations, and initialisation waits for more.
test::TexturedScene reliefScene() {
  test::TexturedScene scene = test::TexturedScene::wallWithPanels();
  constexpr double kDepths[] = {0.9, 1.3, 1.05, 1.2, 0.8, 1.4};
  std::uint32_t seed = 10;
  for (int column = 0; column < 6; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double z = kDepths[(column + 2 * row) % 6];
      const Vec3d center(0.3 * column - 0.6, 0.35 * row - 0.35, z);
      scene.add({center, Vec3d(0.09, 0, 0.02), Vec3d(0, 0.11, 0), seed++});
    }
  }
  return scene;
}

SE3d cameraAt(int frame) {
  const double x = kStep * frame;
  return {so3Exp(Vec3d(0.02 * x, -0.1 * x, 0.05 * x)), Vec3d(x, 0.1 * x * x, 0.05 * x)};
}

}  // namespace

void writeRenderedDataset(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "rgb");
  const test::TexturedScene scene = reliefScene();
  const CameraModel camera =
      CameraModel::create({320, 240, 260, 260, 159.5, 119.5, DistortionModel::none, {}}).value();
  std::string list;
  Trajectory truth;
  for (int i = 0; i < kRenderedFrames; ++i) {
    const ImageU8 image = scene.render(camera, cameraAt(i), {});
    const cv::Mat view(image.height(),
                       image.width(),
                       CV_8UC1,
                       const_cast<std::uint8_t*>(image.row(0)),
                       static_cast<std::size_t>(image.stride()));
    const std::string name = "rgb/" + std::to_string(i) + ".png";
    cv::imwrite((folder / name).string(), view);
    const std::int64_t t_ns = 1'000'000'000 + i * kPeriodNs;
    list += secondsText(t_ns) + " " + name + "\n";
    truth.push_back({t_ns, cameraAt(i)});
  }
  writeFile(folder / "rgb.txt", list);
  writeFile(folder / "groundtruth.txt", tumText(truth));
  writeFile(folder / "calibration.yaml", kCalibration);
}

}  // namespace glide::replay
