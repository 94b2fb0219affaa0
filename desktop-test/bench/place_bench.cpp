// The place index with 1000 keyframes of 1000 features, made up and real (../shared/data), and
// relocalisation in a synthetic map. Run with glide_bench --benchmark_filter="Place|relocalize".
#include "support/data_path.h"
#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include "loop/relocalizer.h"

#include "feature/orb_extractor.h"
#include "map/place_index.h"

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace glide {
namespace {

constexpr std::size_t kKeyframes = 1000, kFeatures = 1000;
constexpr int kResults = 10;
constexpr std::uint64_t kLeftOut = 20;  // every 20th image asks, the others are keyframes

struct Places {
  std::vector<FeatureSet> keyframes, queries;

  void add(std::size_t index, FeatureSet features) {
    std::vector<FeatureSet>& to = index % kLeftOut == kLeftOut / 2 ? queries : keyframes;
    to.push_back(std::move(features));
  }
};

/// A path along 100 000 corners; each view turns over 20 of the 256 bits.
Places madeUpPlaces() {
  std::mt19937_64 random(1);
  std::vector<Descriptor> corners(100 * kFeatures);
  for (Descriptor& corner : corners)
    for (std::uint64_t& word : corner) word = random();
  Places places;
  for (std::size_t k = 0; k < kKeyframes + kKeyframes / 10; ++k) {
    const std::size_t first = random() % (corners.size() - kFeatures);
    std::vector<Descriptor> seen(corners.begin() + static_cast<std::ptrdiff_t>(first),
                                 corners.begin() + static_cast<std::ptrdiff_t>(first + kFeatures));
    for (Descriptor& descriptor : seen) {
      for (int flip = 0; flip < 20; ++flip) {
        const std::uint64_t bit = random() % 256;
        descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
      }
    }
    places.add(k, FeatureSet(std::vector<Feature>(kFeatures), std::move(seen), 640, 480));
  }
  return places;
}

/// All images of the real sequences; empty where they are missing.
Places realPlaces() {
  std::vector<std::filesystem::path> images;
  for (const char* folder : {"euroc_MH01_5s-21s/mav0/cam0/data",
                             "desk_fisheye_400/rgb",
                             "kitti07_160/rgb",
                             "checkerboard_300/rgb"}) {
    const auto path = test::sharedData(folder);
    if (!path) continue;
    for (const auto& file : std::filesystem::directory_iterator(*path))
      images.push_back(file.path());
  }
  std::sort(images.begin(), images.end());
  OrbExtractor extractor{Config::Features{}};
  Places places;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const cv::Mat image = cv::imread(images[i].string(), cv::IMREAD_GRAYSCALE);
    const ImageViewU8 view{
        image.data, image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step)};
    places.add(i, extractor.extract(view, static_cast<int>(kFeatures)));
  }
  return places;
}

enum class Source { made_up, real };

const Places& placesOf(Source source) {
  static const Places made_up = madeUpPlaces();
  if (source == Source::made_up) return made_up;
  static const Places real = realPlaces();
  return real;
}

PlaceIndex indexOf(const Places& places) {
  PlaceIndex index;
  const std::size_t count = std::min(places.keyframes.size(), kKeyframes);
  for (std::size_t k = 0; k < count; ++k) index.add(KeyframeId{k}, places.keyframes[k]);
  return index;
}

bool isReady(benchmark::State& bench, const Places& places) {
  const bool ready = places.keyframes.size() >= kKeyframes;
  if (!ready) bench.SkipWithError("../shared/data is missing");
  return ready;
}

void queryPlaces(benchmark::State& bench, Source source) {
  const Places& places = placesOf(source);
  if (!isReady(bench, places)) return;
  const PlaceIndex index = indexOf(places);
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : bench) {
    benchmark::DoNotOptimize(index.query(places.queries[next], kResults));
    next = (next + 1) % places.queries.size();
  }
  bench.counters["keyframes"] = static_cast<double>(index.size());
}
BENCHMARK_CAPTURE(queryPlaces, made_up, Source::made_up)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(queryPlaces, real, Source::real)->Unit(benchmark::kMillisecond);

/// One more keyframe in, the oldest out.
void replacePlace(benchmark::State& bench, Source source) {
  const Places& places = placesOf(source);
  if (!isReady(bench, places)) return;
  PlaceIndex index = indexOf(places);
  std::uint64_t oldest = 0;
  for ([[maybe_unused]] auto _ : bench) {
    index.remove(KeyframeId{oldest});
    index.add(KeyframeId{oldest + kKeyframes}, places.keyframes[oldest % kKeyframes]);
    ++oldest;
  }
}
BENCHMARK_CAPTURE(replacePlace, real, Source::real)->Unit(benchmark::kMillisecond);

void addPlaces(benchmark::State& bench, Source source) {
  const Places& places = placesOf(source);
  if (!isReady(bench, places)) return;
  for ([[maybe_unused]] auto _ : bench) benchmark::DoNotOptimize(indexOf(places).size());
}
BENCHMARK_CAPTURE(addPlaces, real, Source::real)->Unit(benchmark::kMillisecond);

/// A lost frame of a known place, and one of a strange place.
void relocalize(benchmark::State& bench, std::uint64_t seed) {
  const CameraModel lens = test::syntheticCamera(DistortionModel::radial_tangential);
  test::SyntheticCloudOptions cloud;
  cloud.points = 3000;
  cloud.noise_px = 0.5;
  cloud.flipped_bits = 20;
  cloud.missed_share = 0.3;
  test::DriftedMap map(cloud, lens, test::Drift::Zero());
  for (int k = 0; k < 20; ++k) map.add(test::lookAlong(Vec3d(0.3 * k, 0.0, 0.0), 0.0));
  const auto snapshot = map.snapshot();
  cloud.seed = seed;
  test::SyntheticCloud seen(lens, cloud);
  const auto view = seen.look(test::lookAlong(Vec3d(3.1, 0.2, 0.1), 0.05));
  const RelocalizationQuery query{0, view.features};
  const Relocalizer relocalizer(Config{}, lens);
  int inliers = 0;
  for ([[maybe_unused]] auto _ : bench) {
    const auto found = relocalizer.relocalize(query, *snapshot, map.index());
    inliers = found ? found->inliers : 0;
  }
  bench.counters["features"] = static_cast<double>(view.features->size());
  bench.counters["inliers"] = inliers;
}
BENCHMARK_CAPTURE(relocalize, inKnownPlace, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(relocalize, inForeignPlace, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
