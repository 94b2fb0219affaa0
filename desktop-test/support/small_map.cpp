#include "support/small_map.h"

#include "map/snapshot_builder.h"

#include "geometry/camera_model.h"

#include <random>
#include <utility>

namespace glide::test {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr std::uint64_t kRevision = 17;

double uniform(double low, double high, std::mt19937_64* random) {
  return std::uniform_real_distribution<double>(low, high)(*random);
}

std::vector<FeaturePatch> randomPatches(std::size_t count, std::mt19937_64* random) {
  std::vector<FeaturePatch> patches(count);
  for (FeaturePatch& patch : patches) {
    for (std::uint8_t& pixel : patch.pixels) pixel = static_cast<std::uint8_t>((*random)());
    patch.offset = {static_cast<float>(uniform(-0.5, 0.5, random)), 0.25F};
  }
  return patches;
}

std::shared_ptr<const FeatureSet> randomFeatures(const SmallMapOptions& options,
                                                 std::mt19937_64* random) {
  const auto count = static_cast<std::size_t>(options.features);
  std::vector<Feature> features(count);
  std::vector<Descriptor> descriptors(count);
  for (std::size_t i = 0; i < count; ++i) {
    features[i].uv = {static_cast<float>(uniform(0.0, kWidth - 1.0, random)),
                      static_cast<float>(uniform(0.0, kHeight - 1.0, random))};
    features[i].angle = static_cast<float>(uniform(-3.0, 3.0, random));
    features[i].response = static_cast<float>(uniform(7.0, 90.0, random));
    features[i].level = static_cast<std::uint8_t>((*random)() % 8);
    for (std::uint64_t& word : descriptors[i]) word = (*random)();
  }
  FeatureSet set(std::move(features), std::move(descriptors), kWidth, kHeight);
  if (options.has_patches) set = std::move(set).withPatches(randomPatches(count, random));
  return std::make_shared<const FeatureSet>(std::move(set));
}

void addKeyframes(const SmallMapOptions& options, std::mt19937_64* random, Map* map) {
  for (int k = 0; k < options.keyframes; ++k) {
    Keyframe keyframe;
    keyframe.id = KeyframeId{static_cast<std::uint64_t>(3 * k + 2)};
    keyframe.t_ns = 1'000'000'000 + k * 100'000'000LL;
    keyframe.T_cam_world.q = so3Exp(Vec3d(0.0, 0.1 * k, 0.01));
    keyframe.T_cam_world.t = Vec3d(-0.2 * k, uniform(-0.1, 0.1, random), 0.0);
    keyframe.features = randomFeatures(options, random);
    map->addKeyframe(std::move(keyframe));
  }
}

void addLandmarks(const SmallMapOptions& options, std::mt19937_64* random, Map* map) {
  const KeyframeId first = map->keyframes().begin()->first;
  for (int i = 0; i < options.features - options.features / 4; ++i) {
    const Vec3d p_world(uniform(-2.0, 2.0, random), uniform(-1.0, 1.0, random), 4.0 + 0.1 * i);
    const LandmarkId landmark = map->addLandmark(p_world, first);
    for (const auto& [id, keyframe] : map->keyframes()) {
      const bool is_needed = map->landmark(landmark)->observations.size() < 3;
      if (is_needed || (*random)() % 2 == 0) map->addObservation(landmark, {id, i});
    }
    map->countSighting({landmark, i, i / 2});
  }
}

}  // namespace

Map smallMap(const SmallMapOptions& options) {
  std::mt19937_64 random(options.seed);
  Map map(ScaleLevels(1.2, 8));
  addKeyframes(options, &random, &map);
  addLandmarks(options, &random, &map);
  map.addLoopEdge({map.keyframes().rbegin()->first, map.keyframes().begin()->first});
  KeyframeMove move{map.keyframes().rbegin()->first, Sim3d{}};
  move.S_new_old.s = 1.25;
  map.moveKeyframe(move);
  map.retireKeyframe(std::next(map.keyframes().begin())->first);
  map.refreshChanged();
  return map;
}

StoredMap storedSmallMap(const SmallMapOptions& options) {
  const Map map = smallMap(options);
  SnapshotStamp stamp;
  stamp.revision = kRevision;
  CameraIntrinsics camera{kWidth,
                          kHeight,
                          400.0,
                          401.0,
                          319.5,
                          239.5,
                          DistortionModel::kannala_brandt4,
                          {0.01, -0.002, 0.0003, -0.00001}};
  return {snapshotOf(map, stamp), std::move(camera), map.levels()};
}

MapSnapshot::Parts partsOf(const MapSnapshot& map) {
  MapSnapshot::Parts parts;
  parts.revision = map.revision();
  parts.keyframes = map.keyframes();
  parts.landmarks = map.landmarks();
  parts.retired = map.retired();
  parts.loops = map.loops();
  return parts;
}

}  // namespace glide::test
