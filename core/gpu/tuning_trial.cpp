#include "gpu/tuning_trial.h"

#include "gpu/gpu_aligner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glide {
namespace {

/// The first frame of a program builds what drivers build late; the fastest of the others counts,
/// since whatever disturbs them makes them slower. A slow device is tried with fewer frames.
constexpr int kMaxFrames = 6, kMinFrames = 2;
constexpr double kFramesBudgetMs = 30.0;

/// Scene units: all points are at this distance.
constexpr double kDistance = 1.5;

/// The guess is so far from the truth, which is no motion: a few iterations on every level.
constexpr double kGuessShift = 0.01;  // scene units
constexpr double kGuessTurn = 0.004;  // radians
/// A candidate that ends farther away computes something else. Scene units.
constexpr double kMaxError = 1e-3;

/// A number that looks random, the same for the same cell.
std::uint32_t scramble(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9e3779b1U ^ y * 0x85ebca77U;
  h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
  return h ^ (h >> 12);
}

/// Blotches of `cell` pixels, grey levels 0..255, smooth between cells.
double blotch(int x, int y, int cell) {
  const auto corner = [&](int i, int j) {
    return static_cast<double>(scramble(static_cast<std::uint32_t>(x / cell + i),
                                        static_cast<std::uint32_t>(y / cell + j)) &
                               0xFFU);
  };
  const double u = static_cast<double>(x % cell) / cell;
  const double v = static_cast<double>(y % cell) / cell;
  const double upper = corner(0, 0) * (1.0 - u) + corner(1, 0) * u;
  const double lower = corner(0, 1) * (1.0 - u) + corner(1, 1) * u;
  return upper * (1.0 - v) + lower * v;
}

/// Texture that fine and coarse levels see.
ImageU8 texturedImage(int width, int height) {
  constexpr int kFine = 6, kCoarse = 64;  // pixels
  ImageU8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) =
          static_cast<std::uint8_t>((blotch(x, y, kFine) + blotch(x, y, kCoarse)) / 2.0);
    }
  }
  return image;
}

/// About `count` points on a lattice over the image.
std::vector<AlignPoint> latticePoints(const CameraModel& camera, int count) {
  const double area = static_cast<double>(camera.width()) * camera.height();
  const double step = std::sqrt(area / count);
  std::vector<AlignPoint> points;
  for (double v = step / 2.0; v < camera.height(); v += step) {
    for (double u = step / 2.0; u < camera.width(); u += step) {
      if (const auto bearing = camera.unproject({u, v})) points.push_back({*bearing * kDistance});
    }
  }
  return points;
}

SE3d guess() {
  Vec6d twist;
  twist << kGuessShift, -kGuessShift, kGuessShift, kGuessTurn, -kGuessTurn, kGuessTurn;
  return SE3d::exp(twist);
}

}  // namespace

TuningProbe TuningTrial::probe(const ProgramCache& programs) {
  return {[this, programs](const GpuTuning& tuning) { return frameMs(tuning, programs); },
          [this] { return now_ms_ += clock_.lapMs(); }};
}

const TuningTrial::Scene& TuningTrial::scene() {
  if (!scene_) {
    scene_ = Scene{texturedImage(camera_.width(), camera_.height()),
                   latticePoints(camera_, config_.direct.max_points)};
  }
  return *scene_;
}

std::optional<double> TuningTrial::frameMs(const GpuTuning& tuning, const ProgramCache& programs) {
  auto aligner = GpuAligner::createWith(
      caps_, config_.direct, camera_, tuning, {GpuTiming::passive, config_.gl.state, programs});
  if (!aligner) return std::nullopt;
  const Scene& scene = this->scene();
  if (!(*aligner)->loadFrame(scene.image.view())) return std::nullopt;
  (*aligner)->promoteReference(scene.points_ref);
  Stopwatch clock;
  double fastest_ms = std::numeric_limits<double>::infinity();
  double spent_ms = 0.0;
  for (int i = 0; i < kMinFrames || (i < kMaxFrames && spent_ms < kFramesBudgetMs); ++i) {
    if (!(*aligner)->loadFrame(scene.image.view())) return std::nullopt;
    const AlignResult result = (*aligner)->align(guess());
    if (!result.valid || result.T_cam_ref.t.norm() > kMaxError) return std::nullopt;
    const AlignTimes times = (*aligner)->times();
    if (i > 0) fastest_ms = std::min(fastest_ms, times.pyramid_ms + times.align_ms);
    spent_ms += clock.lapMs();
  }
  return fastest_ms;
}

}  // namespace glide
