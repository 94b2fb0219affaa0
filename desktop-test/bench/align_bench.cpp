// Times the stages of a direct frame on the CPU: pyramid, inverse-compositional cache, alignment.
// 752x480, radial-tangential lens, 400 points, six levels, as the EuRoC sequences are run.
#include "support/textured_scene.h"

#include "photometric/cpu_aligner.h"

#include "image/pyramid.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

namespace glide {
namespace {

constexpr unsigned kSeed = 5;

CameraModel eurocCamera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 752;
  intrinsics.height = 480;
  intrinsics.fx = 458.654;
  intrinsics.fy = 457.296;
  intrinsics.cx = 367.215;
  intrinsics.cy = 248.375;
  intrinsics.distortion = DistortionModel::radial_tangential;
  intrinsics.coefficients = {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05};
  return CameraModel::create(intrinsics).value();
}

SE3d movedCamera() {
  Vec6d twist;
  twist << 0.03, -0.02, 0.02, 0.01, -0.015, 0.02;  // scene units at 1.5 depth, radians
  return SE3d::exp(twist);
}

struct Setup {
  CameraModel camera = eurocCamera();
  test::TexturedScene scene = test::TexturedScene::wallWithPanels();
  ImageU8 reference = scene.render(camera, SE3d{}, {});
  ImageU8 frame = scene.render(camera, movedCamera(), {});
  std::vector<AlignPoint> points;
  Config::Direct config;
  std::unique_ptr<CpuAligner> aligner;

  explicit Setup(int patch_size) {
    config.patch_size = patch_size;
    for (const Vec3d& p_ref : scene.samplePoints(camera, SE3d{}, config.max_points, kSeed)) {
      points.push_back({p_ref});
    }
    aligner = CpuAligner::create(config, camera).value();
    aligner->loadFrame(reference.view());
    aligner->promoteReference(points);
  }
};

void buildPyramidOfFrame(benchmark::State& bench) {
  const ImageU8 image = test::TexturedScene::wallWithPanels().render(eurocCamera(), SE3d{}, {});
  Pyramid pyramid;
  for (auto _ : bench) buildPyramid(image.view(), Config::Direct{}.levels, &pyramid);
}
BENCHMARK(buildPyramidOfFrame)->Unit(benchmark::kMicrosecond);

void promoteReference(benchmark::State& bench) {
  Setup setup(static_cast<int>(bench.range(0)));
  for (auto _ : bench) setup.aligner->promoteReference(setup.points);
}
BENCHMARK(promoteReference)->Arg(7)->Arg(11)->Unit(benchmark::kMicrosecond);

void alignFrame(benchmark::State& bench) {
  Setup setup(static_cast<int>(bench.range(0)));
  setup.aligner->loadFrame(setup.frame.view());
  AlignResult result;
  for (auto _ : bench) result = setup.aligner->align(SE3d{});
  int iterations = 0;
  for (const int count : result.iterations) iterations += count;
  bench.counters["iterations"] = iterations;
  bench.counters["error_mm"] = 1e3 * (result.T_cam_ref * movedCamera()).t.norm();
}
BENCHMARK(alignFrame)->Arg(7)->Arg(11)->Unit(benchmark::kMicrosecond);

/// A whole direct frame: pyramid and alignment.
void directFrame(benchmark::State& bench) {
  Setup setup(static_cast<int>(bench.range(0)));
  for (auto _ : bench) {
    setup.aligner->loadFrame(setup.frame.view());
    benchmark::DoNotOptimize(setup.aligner->align(SE3d{}));
  }
}
BENCHMARK(directFrame)->Arg(7)->Arg(11)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace glide
