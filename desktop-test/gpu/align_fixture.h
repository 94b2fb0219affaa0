#pragma once

#include "support/textured_scene.h"

#include "gpu/gl_test.h"
#include "photometric/align_types.h"

#include "geometry/camera_model.h"
#include "image/pyramid.h"

#include "glide/config.h"

#include <vector>

namespace glide::test {

/// Cameras of the three models that look into the textured scene, for images of a given size.
CameraModel testCamera(DistortionModel model, int width, int height);
inline constexpr DistortionModel kCameraModels[] = {
    DistortionModel::none, DistortionModel::radial_tangential, DistortionModel::kannala_brandt4};

/// A reference image and a frame of the textured scene, with points of the reference and the true
/// motion.
struct AlignScene {
  CameraModel camera;
  ImageU8 reference, frame;
  std::vector<AlignPoint> points_ref;
  SE3d T_cam_ref;  ///< truth

  /// Levels of the reference / of the frame, by the CPU.
  Pyramid referencePyramid(int levels) const;
  Pyramid framePyramid(int levels) const;
};

/// What the scene looks like.
struct AlignSceneOptions {
  DistortionModel model = DistortionModel::radial_tangential;
  int width = 0, height = 0;
  int points = 0;
  SE3d T_cam_ref;
  Exposure exposure;
};

AlignScene makeAlignScene(const AlignSceneOptions& options);

/// A tween frame's motion: a few pixels.
SE3d smallMotion();

}  // namespace glide::test
