#include "gpu/align_fixture.h"

namespace glide::test {

CameraModel testCamera(DistortionModel model, int width, int height) {
  CameraIntrinsics intrinsics;
  intrinsics.width = width;
  intrinsics.height = height;
  const double focal = 0.61 * width;  // the field of view of EuRoC's cameras
  intrinsics.fx = focal;
  intrinsics.fy = 0.997 * focal;
  intrinsics.cx = 0.488 * width;
  intrinsics.cy = 0.517 * height;
  intrinsics.distortion = model;
  if (model == DistortionModel::radial_tangential) {
    intrinsics.coefficients = {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05};
  } else if (model == DistortionModel::kannala_brandt4) {
    intrinsics.coefficients = {0.01, -0.02, 0.005, -0.001};
  }
  return CameraModel::create(intrinsics).value();
}

Pyramid AlignScene::referencePyramid(int levels) const {
  Pyramid pyramid;
  buildPyramid(reference.view(), levels, &pyramid);
  return pyramid;
}

Pyramid AlignScene::framePyramid(int levels) const {
  Pyramid pyramid;
  buildPyramid(frame.view(), levels, &pyramid);
  return pyramid;
}

AlignScene makeAlignScene(const AlignSceneOptions& options) {
  constexpr std::uint32_t kSeed = 7;
  const TexturedScene scene = TexturedScene::wallWithPanels();
  const SE3d T_world_ref;
  const SE3d T_world_cam = T_world_ref * options.T_cam_ref.inverse();
  const CameraModel camera = testCamera(options.model, options.width, options.height);
  AlignScene made{camera,
                  scene.render(camera, T_world_ref, Exposure{}),
                  scene.render(camera, T_world_cam, options.exposure),
                  {},
                  options.T_cam_ref};
  for (const Vec3d& p_ref : scene.samplePoints(camera, T_world_ref, options.points, kSeed)) {
    made.points_ref.push_back({p_ref});
  }
  return made;
}

SE3d smallMotion() {
  Vec6d twist;
  twist << 0.012, -0.008, 0.01, 0.004, -0.006, 0.008;
  return SE3d::exp(twist);
}

}  // namespace glide::test
