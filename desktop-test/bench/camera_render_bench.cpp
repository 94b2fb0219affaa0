// What the camera view costs, 752x480 into a multisampled target of that size, until the GPU is
// done: the picture, 400 tracked points with trails of ten steps, axes and ten cubes. Skips where
// there is no GL.
#include "support/egl_context.h"

#include "gpu/gl.h"

#include "glide/camera_renderer.h"
#include "glide/render_target.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr int kWidth = 752, kHeight = 480;  // of EuRoC
constexpr Viewport kViewport{0, 0, kWidth, kHeight};
constexpr int kPoints = 400;  // Config::Direct::max_points
constexpr int kPictures = 12;
constexpr int kCubes = 10;

CameraIntrinsics camera() {
  CameraIntrinsics camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.fx = camera.fy = 458.0;
  camera.cx = 0.5 * kWidth;
  camera.cy = 0.5 * kHeight;
  camera.distortion = DistortionModel::radial_tangential;
  camera.coefficients = {-0.283, 0.074, 0.0, 0.0};
  return camera;
}

/// A context with a target bound; without one the benchmark is skipped.
class CameraSetup {
 public:
  explicit CameraSetup(benchmark::State* bench)
      : context_(test::EglContext::create(test::EglDebug::off)) {
    Result<RenderTarget> target = RenderTarget::create(kWidth, kHeight);
    Result<CameraRenderer> renderer = CameraRenderer::create(GlStatePolicy::preserve, camera());
    if (!target || !renderer) {
      bench->SkipWithError("no OpenGL ES 3.1");
      return;
    }
    bench->SetLabel(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    target_.emplace(std::move(*target));
    renderer_.emplace(std::move(*renderer));
    target_->begin({0.0F, 0.0F, 0.0F, 1.0F});
  }
  bool isReady() const { return renderer_.has_value(); }
  CameraRenderer& renderer() { return *renderer_; }

 private:
  Result<test::EglContext> context_;
  std::optional<RenderTarget> target_;
  std::optional<CameraRenderer> renderer_;
};

/// Points that move by three pixels a picture.
std::vector<TrackedPoint> pointsOf(int picture) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  std::vector<TrackedPoint> points(kPoints);
  std::uint64_t landmark = 0;
  for (TrackedPoint& point : points) {
    point.landmark = ++landmark;
    point.u = kWidth * unit(random) + 3.0F * static_cast<float>(picture);
    point.v = kHeight * unit(random);
    point.residual = 25.0F * unit(random);
    point.inlier = unit(random) < 0.9F;
  }
  return points;
}

void drawPicture(benchmark::State& bench) {
  CameraSetup setup(&bench);
  if (!setup.isReady()) return;
  const std::vector<std::uint8_t> luma(static_cast<std::size_t>(kWidth) * kHeight, 90);
  for ([[maybe_unused]] auto _ : bench) {
    setup.renderer().drawPicture(Luma{luma.data(), kWidth, kHeight, kWidth}, kViewport);
    glFinish();
  }
}

void drawPoints(benchmark::State& bench) {
  CameraSetup setup(&bench);
  if (!setup.isReady()) return;
  int picture = 0;
  for (; picture < kPictures; ++picture)
    setup.renderer().drawPoints(pointsOf(picture), TrackerKind::direct, kViewport);
  for ([[maybe_unused]] auto _ : bench) {
    bench.PauseTiming();
    const std::vector<TrackedPoint> points = pointsOf(picture++ % kPictures);
    glFinish();
    bench.ResumeTiming();
    setup.renderer().drawPoints(points, TrackerKind::direct, kViewport);
    glFinish();
  }
}

void drawAr(benchmark::State& bench) {
  CameraSetup setup(&bench);
  if (!setup.isReady()) return;
  std::vector<Pose> cubes(kCubes);
  for (int i = 0; i < kCubes; ++i)
    cubes[static_cast<std::size_t>(i)].t_xyz = {0.3 * (i % 5 - 2), 0.3, 1.2 + 0.4 * (i / 5)};
  ArContent content;
  content.cubes = cubes;
  for ([[maybe_unused]] auto _ : bench) {
    setup.renderer().drawAr(content, {}, kViewport);
    glFinish();
  }
}

BENCHMARK(drawPicture)->Name("CameraPicture")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawPoints)->Name("CameraPoints")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(drawAr)->Name("CameraAr")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace glide
