// Times the stages of a direct frame on OpenGL ES 3.1: pyramid, inverse-compositional cache,
// alignment. The scene of align_bench.cpp. Arguments: patch size, workgroup size. Skips where there
// is no GL.
#include "support/egl_context.h"
#include "support/textured_scene.h"

#include "gpu/gl_caps.h"
#include "gpu/gpu_aligner.h"

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

/// A context with an aligner in it that holds a reference; without GL the benchmark is skipped.
class GpuSetup {
 public:
  explicit GpuSetup(benchmark::State* bench)
      : context_(test::EglContext::create(test::EglDebug::off)) {
    const Result<GlCaps> caps = GlCaps::query();
    if (!caps) {
      bench->SkipWithError(caps.error().message.c_str());
      return;
    }
    bench->SetLabel(caps->renderer);
    const test::TexturedScene scene = test::TexturedScene::wallWithPanels();
    const CameraModel camera = eurocCamera();
    Config::Direct direct;
    direct.patch_size = static_cast<int>(bench->range(0));
    for (const Vec3d& p_ref : scene.samplePoints(camera, SE3d{}, direct.max_points, kSeed)) {
      points_.push_back({p_ref});
    }
    frame_ = scene.render(camera, movedCamera(), {});
    GpuTuning tuning;
    tuning.group_size = static_cast<int>(bench->range(1));
    aligner_ = GpuAligner::createTuned(*caps, direct, camera, tuning).value();
    aligner_->loadFrame(scene.render(camera, SE3d{}, {}).view());
    aligner_->promoteReference(points_);
    aligner_->align(SE3d{});  // builds what drivers build at first use
  }

  /// Null when the benchmark is skipped.
  Aligner* aligner() { return aligner_.get(); }
  const ImageU8& frame() const { return frame_; }
  const std::vector<AlignPoint>& points() const { return points_; }

 private:
  Result<test::EglContext> context_;
  std::vector<AlignPoint> points_;
  ImageU8 frame_;
  std::unique_ptr<Aligner> aligner_;
};

void variants(benchmark::internal::Benchmark* benchmark) {
  for (const int group_size : {32, 64, 128}) {
    for (const int patch_size : {7, 11}) benchmark->Args({patch_size, group_size});
  }
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

void gpuLoadFrame(benchmark::State& bench) {
  GpuSetup setup(&bench);
  if (setup.aligner() == nullptr) return;
  for (auto _ : bench) {
    setup.aligner()->loadFrame(setup.frame().view());
    glFinish();
  }
}
BENCHMARK(gpuLoadFrame)->Apply(variants);

void gpuPromoteReference(benchmark::State& bench) {
  GpuSetup setup(&bench);
  if (setup.aligner() == nullptr) return;
  for (auto _ : bench) {
    setup.aligner()->promoteReference(setup.points());
    glFinish();
  }
}
BENCHMARK(gpuPromoteReference)->Apply(variants);

/// A whole direct frame: upload, pyramid, alignment, readback.
void gpuDirectFrame(benchmark::State& bench) {
  GpuSetup setup(&bench);
  if (setup.aligner() == nullptr) return;
  AlignResult result;
  for (auto _ : bench) {
    setup.aligner()->loadFrame(setup.frame().view());
    result = setup.aligner()->align(SE3d{});
  }
  int iterations = 0;
  for (const int count : result.iterations) iterations += count;
  bench.counters["iterations"] = iterations;
  bench.counters["error_mm"] = 1e3 * (result.T_cam_ref * movedCamera()).t.norm();
  bench.counters["pyramid_ms"] = setup.aligner()->times().pyramid_ms;
  bench.counters["align_ms"] = setup.aligner()->times().align_ms;
}
BENCHMARK(gpuDirectFrame)->Apply(variants);

}  // namespace
}  // namespace glide
