#include "bench/gpu/bench_scene.h"

#include "support/textured_scene.h"

namespace glide::gpubench {
namespace {

constexpr unsigned kSeed = 5;
constexpr int kViews = 8;

/// Where view `index` is taken from.
SE3d viewPose(int index) {
  Vec6d furthest;
  furthest << 0.03, -0.02, 0.02, 0.01, -0.015, 0.02;  // scene units at 1.5 depth, radians
  return SE3d::exp(furthest * (static_cast<double>(index + 1) / kViews));
}

/// Whether the patch around a pixel of level 0 lies in a level, as align_precompute.comp asks.
bool fits(const Vec2d& uv, const Workload& workload, int level) {
  const Vec2d at = uv / static_cast<double>(1 << level);
  const int low = workload.patch / 2 + 1, high = low + 1;
  return at.x() >= low && at.y() >= low && at.x() < levelSide(workload.width, level) - high &&
         at.y() < levelSide(workload.height, level) - high;
}

}  // namespace

CameraModel benchCamera(int width, int height) {
  constexpr double kWidth = 752.0, kFocal = 458.654;  // px
  CameraIntrinsics intrinsics;
  intrinsics.width = width;
  intrinsics.height = height;
  intrinsics.fx = intrinsics.fy = kFocal * width / kWidth;
  intrinsics.cx = 0.5 * (width - 1);
  intrinsics.cy = 0.5 * (height - 1);
  intrinsics.distortion = DistortionModel::radial_tangential;
  intrinsics.coefficients = {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05};
  return CameraModel::create(intrinsics).value();
}

PerLevel pointsOfLevels(const BenchScene& scene, const Workload& workload) {
  PerLevel counts{};
  for (const AlignPoint& point : scene.points_ref) {
    const auto uv = scene.camera.project(point.p_ref);
    if (!uv) continue;
    for (int level = 0; level < workload.levels; ++level) {
      counts[static_cast<std::size_t>(level)] += fits(*uv, workload, level) ? 1.0 : 0.0;
    }
  }
  return counts;
}

BenchScene makeBenchScene(const Workload& workload) {
  const auto wall = test::TexturedScene::wallWithPanels();
  BenchScene scene{benchCamera(workload.width, workload.height), {}, {}, {}};
  scene.reference = wall.render(scene.camera, SE3d{}, {});
  for (int i = 0; i < kViews; ++i) {
    scene.frames.push_back(wall.render(scene.camera, viewPose(i), {}));
  }
  for (const Vec3d& p_ref : wall.samplePoints(scene.camera, SE3d{}, workload.points, kSeed)) {
    scene.points_ref.push_back({p_ref});
  }
  return scene;
}

}  // namespace glide::gpubench
