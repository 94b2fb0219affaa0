// What a picture of a large map costs: 20 000 landmarks, 200 keyframes, 2000 frames, at 1280x720.
// Skips where there is no GL.
#include "support/egl_context.h"
#include "support/room_map.h"

#include "gpu/gl.h"
#include "gpu/gl_caps.h"

#include "glide/map_renderer.h"
#include "glide/render_target.h"

#include <benchmark/benchmark.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace glide {
namespace {

constexpr Viewport kPicture{0, 0, 1280, 720};
constexpr Viewport kInset{1060, 20, 200, 200};
constexpr Color kPaper{0.965F, 0.97F, 0.98F, 1.0F};
constexpr test::RoomMapSize kLarge{20'000, 200, 2000};

Matrix4 columnMajor(const glm::mat4& matrix) {
  Matrix4 values{};
  std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
  return values;
}

/// The room from above a corner.
ViewCamera cornerView() {
  constexpr glm::vec3 kEye(-2.6F, -2.6F, -2.2F), kTarget(0.0F, 0.1F, 1.3F), kUp(0.0F, -1.0F, 0.0F);
  constexpr float kFieldOfView = 0.9F, kNear = 0.05F, kFar = 100.0F;  // radians, scene units
  constexpr float kAspect = static_cast<float>(kPicture.width) / kPicture.height;
  return {columnMajor(glm::lookAt(kEye, kTarget, kUp)),
          columnMajor(glm::perspective(kFieldOfView, kAspect, kNear, kFar))};
}

/// A context with a target and a renderer that has the room; without one the benchmark is skipped.
class RenderSetup {
 public:
  explicit RenderSetup(benchmark::State* bench)
      : context_(test::EglContext::create(test::EglDebug::off)) {
    const Result<GlCaps> caps = GlCaps::query();
    if (!caps) {
      bench->SkipWithError(caps.error().message.c_str());
      return;
    }
    bench->SetLabel(caps->renderer);
    Result<RenderTarget> target = RenderTarget::create(kPicture.width, kPicture.height);
    Result<MapRenderer> renderer = MapRenderer::create(GlStatePolicy::preserve);
    if (!target || !renderer) {
      bench->SkipWithError("no target");
      return;
    }
    target_.emplace(std::move(*target));
    renderer_.emplace(std::move(*renderer));
    renderer_->setMap(room_.map);
    for (const FrameResult& frame : room_.frames) renderer_->addFrame(frame);
  }

  bool isReady() const { return renderer_.has_value(); }
  MapRenderer& renderer() { return *renderer_; }
  const test::RoomMap& room() const { return room_; }
  /// One picture, finished.
  void draw() {
    target_->begin(kPaper);
    benchmark::DoNotOptimize(renderer_->draw(corner_, kPicture).ok());
    glFinish();
  }

 private:
  Result<test::EglContext> context_;
  test::RoomMap room_ = test::makeRoomMap(kLarge);
  ViewCamera corner_ = cornerView();
  std::optional<RenderTarget> target_;
  std::optional<MapRenderer> renderer_;
};

void BM_MapPicture(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  setup.draw();
  for (auto _ : state) setup.draw();
  state.counters["draw_calls"] = setup.renderer().drawCalls();
}
BENCHMARK(BM_MapPicture)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// The same with a frustum for every frame.
void BM_MapPictureWithFrameFrusta(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  MapStyle style;
  style.frame_frusta = true;
  setup.renderer().setStyle(style);
  for (auto _ : state) setup.draw();
  state.counters["draw_calls"] = setup.renderer().drawCalls();
}
BENCHMARK(BM_MapPictureWithFrameFrusta)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void BM_MiniMap(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  setup.draw();
  for (auto _ : state) {
    benchmark::DoNotOptimize(setup.renderer().drawMiniMap(kInset).ok());
    glFinish();
  }
}
BENCHMARK(BM_MiniMap)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// The target's clear and resolve alone: what the pictures above contain.
void BM_EmptyPicture(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  setup.renderer().setMap(std::make_shared<MapView>());
  MapStyle nothing;
  nothing.trajectory = false;
  setup.renderer().setStyle(nothing);
  for (auto _ : state) setup.draw();
}
BENCHMARK(BM_EmptyPicture)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

using MapPair = std::array<std::shared_ptr<const MapView>, 2>;

/// The room's map, and the same with all in it moved.
MapPair mapAndCorrected(const test::RoomMap& room) {
  constexpr double kMove = 0.01;
  auto moved = std::make_shared<MapView>(*room.map);
  for (MapView::Keyframe& keyframe : moved->keyframes) keyframe.T_world_cam.t_xyz[0] += kMove;
  for (MapView::Landmark& landmark : moved->landmarks) landmark.p_world[0] += kMove;
  return {room.map, moved};
}

/// A map in which every keyframe and landmark has moved: its records, without the upload.
void BM_TakeCorrectedMap(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  const MapPair maps = mapAndCorrected(setup.room());
  std::size_t next = 0;
  for (auto _ : state) setup.renderer().setMap(maps[next++ % maps.size()]);
}
BENCHMARK(BM_TakeCorrectedMap)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A picture after such a map: with the upload.
void BM_MapPictureAfterCorrection(benchmark::State& state) {
  RenderSetup setup(&state);
  if (!setup.isReady()) return;
  const MapPair maps = mapAndCorrected(setup.room());
  std::size_t next = 0;
  for (auto _ : state) {
    setup.renderer().setMap(maps[next++ % maps.size()]);
    setup.draw();
  }
}
BENCHMARK(BM_MapPictureAfterCorrection)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
