#pragma once

#include "support/textured_scene.h"

#include "photometric/cpu_aligner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace glide::test {

inline constexpr unsigned kPointSeed = 5;
inline constexpr double kDegreesPerRadian = 57.29577951308232;

/// A camera of about 80 degrees of width.
inline CameraModel makeCamera(DistortionModel distortion, int width, int height) {
  CameraIntrinsics intrinsics;
  intrinsics.width = width;
  intrinsics.height = height;
  intrinsics.fx = 0.61 * width;
  intrinsics.fy = 0.608 * width;
  intrinsics.cx = 0.49 * width;
  intrinsics.cy = 0.51 * height;
  intrinsics.distortion = distortion;
  if (distortion == DistortionModel::radial_tangential) {
    intrinsics.coefficients = {-0.283, 0.074, 0.0002, 0.00002};
  } else if (distortion == DistortionModel::kannala_brandt4) {
    intrinsics.coefficients = {-0.01, 0.02, -0.01, 0.002};
  }
  return CameraModel::create(intrinsics).value();
}

inline Vec6d twist(const Vec3d& translation, const Vec3d& rotation) {
  Vec6d out;
  out << translation, rotation;
  return out;
}

/// A hand's motion over one or two frames: about a centimetre and half a degree.
inline SE3d smallMotion() {
  return SE3d::exp(twist({0.009, -0.006, 0.006}, {0.003, -0.0045, 0.006}));
}

/// An error of the prediction: four centimetres and one and a half degrees.
inline SE3d perturbation() { return SE3d::exp(twist({0.02, -0.03, 0.02}, {0.015, 0.015, -0.015})); }

struct PoseError {
  double mm = 0.0;
  double degrees = 0.0;
};

/// Difference of two poses in the scene's unit taken as metres.
inline PoseError poseError(const SE3d& T_cam_ref, const SE3d& T_cam_ref_truth) {
  const Vec6d error = (T_cam_ref * T_cam_ref_truth.inverse()).log();
  return {1e3 * error.head<3>().norm(), kDegreesPerRadian * error.tail<3>().norm()};
}

/// A reference at the origin and a frame at `T_ref_cam` of the same scene.
struct AlignScenario {
  CameraModel camera;
  TexturedScene scene = TexturedScene::wallWithPanels();
  Config::Direct config;
  SE3d T_ref_cam = smallMotion();
  Exposure reference_exposure;
  Exposure frame_exposure;
  int points = 400;

  explicit AlignScenario(CameraModel camera_model) : camera(std::move(camera_model)) {}

  std::vector<AlignPoint> alignPoints() const {
    std::vector<AlignPoint> out;
    for (const Vec3d& p_ref : scene.samplePoints(camera, SE3d{}, points, kPointSeed)) {
      out.push_back({p_ref});
    }
    return out;
  }
  ImageU8 referenceImage() const { return scene.render(camera, SE3d{}, reference_exposure); }
  ImageU8 frameImage() const { return scene.render(camera, T_ref_cam, frame_exposure); }

  std::unique_ptr<CpuAligner> alignerWithReference() const {
    std::unique_ptr<CpuAligner> aligner = CpuAligner::create(config, camera).value();
    aligner->loadFrame(referenceImage().view());
    aligner->promoteReference(alignPoints());
    return aligner;
  }

  AlignResult align(const SE3d& T_cam_ref_guess) const {
    const std::unique_ptr<CpuAligner> aligner = alignerWithReference();
    aligner->loadFrame(frameImage().view());
    return aligner->align(T_cam_ref_guess);
  }

  SE3d truth() const { return T_ref_cam.inverse(); }
  SE3d perturbedGuess() const { return truth() * perturbation(); }
};

inline constexpr int kWidth = 752;
inline constexpr int kHeight = 480;

inline AlignScenario pinholeScenario() {
  return AlignScenario(makeCamera(DistortionModel::none, kWidth, kHeight));
}

/// Half the size, for tests that do not measure accuracy.
inline AlignScenario smallScenario() {
  return AlignScenario(makeCamera(DistortionModel::none, kWidth / 2, kHeight / 2));
}

// The fixture's scene is 1.5 m away: this is what a direct frame is asked to reach.
inline constexpr double kMaxErrorMm = 0.2;
inline constexpr double kMaxErrorDegrees = 0.02;

inline void expectAccurate(const AlignResult& result, const AlignScenario& scenario) {
  const PoseError error = poseError(result.T_cam_ref, scenario.truth());
  EXPECT_TRUE(result.valid);
  EXPECT_LT(error.mm, kMaxErrorMm);
  EXPECT_LT(error.degrees, kMaxErrorDegrees);
}

/// Offset of pixel k of a patch, row by row.
inline Vec2d patchOffset(int k, int size) {
  const int row = k / size;
  const int column = k % size;
  const int half = size / 2;
  return Vec2d(column - half, row - half);
}

/// The plain twin of the sampling kernels: one bilinear sample in double.
inline double bilinear(const ImageF& image, double u, double v) {
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
  const double fx = u - x;
  const double fy = v - y;
  return (1.0 - fy) * ((1.0 - fx) * image.at(x, y) + fx * image.at(x + 1, y)) +
         fy * ((1.0 - fx) * image.at(x, y + 1) + fx * image.at(x + 1, y + 1));
}

}  // namespace glide::test
