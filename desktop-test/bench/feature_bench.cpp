// Times feature extraction and its stages on one image, and matching between two feature sets.
// 752x480 with 1000 features, as the EuRoC sequences are run.
#include "unit/feature/dead_leaves.h"

#include "feature/corner.h"
#include "feature/corner_orientation.h"
#include "feature/descriptor.h"
#include "feature/fast_corners.h"
#include "feature/matcher.h"
#include "feature/orb_extractor.h"
#include "feature/scale_pyramid.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr int kWidth = 752, kHeight = 480, kCount = 1000, kBorder = 16;
constexpr unsigned kSeed = 5;
constexpr float kAngle = 0.05F, kScale = 1.02F;  // of the second view
constexpr float kZoom = 0.6F;                    // the collage is larger than the image

ImageU8 view(float angle, float scale) {
  ImageU8 image =
      test::DeadLeaves(kSeed).render(kWidth, kHeight, test::similarity(angle, kZoom * scale), 0.7F);
  test::addNoise(3.0F, kSeed, &image);
  return image;
}

FeatureSet featuresOf(const ImageU8& image) {
  return OrbExtractor(Config::Features{}).extract(image.view(), kCount);
}

void extractFeatures(benchmark::State& bench) {
  const ImageU8 image = view(0.0F, 1.0F);
  OrbExtractor extractor{Config::Features{}};
  std::size_t found = 0;
  for (auto _ : bench) {
    found = extractor.extract(image.view(), static_cast<int>(bench.range(0))).size();
  }
  bench.counters["features"] = static_cast<double>(found);
}
BENCHMARK(extractFeatures)->Arg(kCount)->Arg(2 * kCount)->Unit(benchmark::kMillisecond);

void buildScalePyramid(benchmark::State& bench) {
  const ImageU8 image = view(0.0F, 1.0F);
  ScalePyramid pyramid({});
  for (auto _ : bench) {
    pyramid.build(image.view());
    benchmark::DoNotOptimize(pyramid.level(0).data);
  }
}
BENCHMARK(buildScalePyramid)->Unit(benchmark::kMillisecond);

/// Corners of level 0, spread.
struct Level0 {
  ImageU8 image = view(0.0F, 1.0F);
  ScalePyramid pyramid{ScalePyramid::Shape{}};
  std::vector<Corner> corners;

  Level0() {
    pyramid.build(image.view());
    detectCorners(pyramid.level(0), kBorder, {20, 7}, &corners);
    keepSpread(kWidth, kHeight, kCount, &corners);
  }
};

void findFastCorners(benchmark::State& bench) {
  const Level0 level;
  std::vector<Corner> corners;
  for (auto _ : bench) fastCorners(level.pyramid.level(0), kBorder, 7, &corners);
  bench.counters["corners"] = static_cast<double>(corners.size());
}
BENCHMARK(findFastCorners)->Unit(benchmark::kMicrosecond);

void refineThousandCorners(benchmark::State& bench) {
  const Level0 level;
  std::vector<Vec2f> uv(level.corners.size());
  for (auto _ : bench) refineCorners(level.pyramid.level(0), level.corners, uv);
}
BENCHMARK(refineThousandCorners)->Unit(benchmark::kMicrosecond);

void orientThousandCorners(benchmark::State& bench) {
  const Level0 level;
  std::vector<float> angles(level.corners.size());
  for (auto _ : bench) cornerAngles(level.pyramid.level(0), level.corners, angles);
}
BENCHMARK(orientThousandCorners)->Unit(benchmark::kMicrosecond);

void describeThousandCorners(benchmark::State& bench) {
  Level0 level;
  const ImageViewU8 smooth = level.pyramid.smoothed(0);
  std::vector<float> angles(level.corners.size());
  cornerAngles(smooth, level.corners, angles);
  const SteeredPattern pattern;
  for (auto _ : bench) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const Corner& c = level.corners[i];
      benchmark::DoNotOptimize(pattern.describe(smooth, c.x, c.y, angles[i]));
    }
  }
}
BENCHMARK(describeThousandCorners)->Unit(benchmark::kMicrosecond);

void matchAllWithAll(benchmark::State& bench) {
  const FeatureSet a = featuresOf(view(0.0F, 1.0F)), b = featuresOf(view(kAngle, kScale));
  std::size_t matches = 0;
  for (auto _ : bench) matches = matchBruteForce(a, {}, b, MatchOptions{}).size();
  bench.counters["matches"] = static_cast<double>(matches);
}
BENCHMARK(matchAllWithAll)->Unit(benchmark::kMicrosecond);

void matchThousandProjections(benchmark::State& bench) {
  const FeatureSet a = featuresOf(view(0.0F, 1.0F)), b = featuresOf(view(kAngle, kScale));
  const Vec2f centre(0.5F * (kWidth - 1), 0.5F * (kHeight - 1));
  const Eigen::Matrix2f A = test::similarity(kAngle, kScale).inverse();
  std::vector<ProjectedTarget> targets;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Feature& f = a.feature(i);
    targets.push_back({static_cast<int>(i),
                       A * (f.uv - centre) + centre,
                       14.0F,
                       std::max(0, f.level - 1),
                       f.level + 1,
                       a.descriptor(i)});
  }
  std::size_t matches = 0;
  for (auto _ : bench) matches = matchByProjection(targets, b, {}, MatchOptions{}).size();
  bench.counters["matches"] = static_cast<double>(matches);
}
BENCHMARK(matchThousandProjections)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace glide
