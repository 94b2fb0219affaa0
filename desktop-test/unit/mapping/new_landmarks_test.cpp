#include "mapping/new_landmarks.h"

#include "support/mapped_scene.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::SyntheticCloudOptions;
using test::walk;

constexpr double kNoise_px = 0.3;

/// Standard deviation of a landmark's distance, over the distance, as its two pixels leave it.
double depthSigma(const MapSnapshot& map,
                  const MapSnapshot::LandmarkEntry& landmark,
                  const CameraModel& camera) {
  const auto rayTo = [&](const Observation& seen) -> Vec3d {
    return (landmark.p_world - map.T_cam_world(seen.keyframe)->inverse().t).normalized();
  };
  const auto levelOf = [&](const Observation& seen) {
    const MapSnapshot::KeyframeEntry& keyframe = *map.keyframe(seen.keyframe);
    return keyframe.features->feature(static_cast<std::size_t>(seen.feature)).level;
  };
  const Observation& a = landmark.observations.front();
  const Observation& b = landmark.observations.back();
  const double parallax = std::acos(std::min(1.0, rayTo(a).dot(rayTo(b))));
  const double noise_px =
      kNoise_px * std::hypot(std::pow(1.2, levelOf(a)), std::pow(1.2, levelOf(b)));
  return noise_px / (camera.fx() * parallax);
}

int wrongLandmarks(const MappedScene& scene, const std::vector<LandmarkId>& created) {
  constexpr double kSigmas = 4.0;
  constexpr double kAlignment = 0.01;  // of the whole map with the truth, over the distance
  const auto snapshot = scene.map();
  const Sim3d S_truth_map = scene.tracker.similarityToMap(*snapshot).inverse();
  int wrong = 0;
  for (const LandmarkId id : created) {
    const auto& landmark = *snapshot->landmark(id);
    const int corner = scene.tracker.cornerOf(landmark);
    const Vec3d& truth = scene.cloud.points()[static_cast<std::size_t>(corner)];
    const double allowed =
        kSigmas * depthSigma(*snapshot, landmark, scene.cloud.camera()) + kAlignment;
    if ((S_truth_map * landmark.p_world - truth).norm() > allowed * truth.norm()) ++wrong;
  }
  return wrong;
}

TEST(NewLandmarks, AreTriangulatedWhereTheCornersAre) {
  SyntheticCloudOptions options = smallCloud();
  options.noise_px = kNoise_px;
  options.flipped_bits = 8;
  int wrong = 0, count = 0;
  for (options.seed = 1; options.seed <= 5; ++options.seed) {
    MappedScene scene(options, {});
    scene.start();
    const KeyframeId id = scene.insert(walk(3));
    const std::vector<LandmarkId> created = createLandmarks(&scene.state, id, nullptr);
    EXPECT_GT(created.size(), 30U);
    EXPECT_EQ(checkConsistency(scene.state.map), "");
    wrong += wrongLandmarks(scene, created);
    count += static_cast<int>(created.size());
  }
  EXPECT_LE(wrong, count / 100);
}

TEST(NewLandmarks, HaveDescriptorNormalAndScaleRange) {
  MappedScene scene(smallCloud(), {});
  scene.start();
  const KeyframeId id = scene.insert(walk(3));
  for (const LandmarkId created : createLandmarks(&scene.state, id, nullptr)) {
    const Landmark& landmark = *scene.state.map.landmark(created);
    EXPECT_NE(landmark.descriptor, Descriptor{});
    EXPECT_NEAR(landmark.normal.norm(), 1.0, 1e-9);
    EXPECT_LT(landmark.min_distance, landmark.max_distance);
    EXPECT_EQ(landmark.first_keyframe, id);
  }
}

TEST(NewLandmarks, NeedABaseline) {
  MappedScene scene(smallCloud(), {});
  scene.start();
  for (const KeyframeId far : {KeyframeId{0}, KeyframeId{1}}) {
    // Everything but the keyframe itself sits on its place: nothing to triangulate with.
    scene.state.map.setPose(far, walk(3));
  }
  const KeyframeId id = scene.insert(walk(3));
  scene.state.map.setPose(id, walk(3));
  EXPECT_TRUE(createLandmarks(&scene.state, id, nullptr).empty());
}

TEST(NewLandmarks, ComeFromFewerNeighborsWhenAnotherKeyframeWaits) {
  MappedScene patient(smallCloud(), {});
  MappedScene hurried(smallCloud(), {});
  const std::atomic<bool> interrupt{true};
  std::size_t with_all = 0;
  std::size_t with_few = 0;
  for (MappedScene* scene : {&patient, &hurried}) {
    scene->start();
    for (int step = 2; step < 9; ++step) scene->insert(walk(step));
    const bool is_hurried = scene == &hurried;
    const auto created =
        createLandmarks(&scene->state, scene->newest(), is_hurried ? &interrupt : nullptr);
    (is_hurried ? with_few : with_all) = created.size();
  }
  EXPECT_GT(with_few, 0U);
  EXPECT_LT(with_few, with_all);
}

TEST(MedianDepth, IgnoresWhatIsBehindAndIsZeroForNothing) {
  MappedScene scene(smallCloud(), {});
  scene.start();
  const Keyframe& first = scene.state.map.keyframes().begin()->second;
  EXPECT_NEAR(medianDepth(scene.state.map, first), 1.0, 1e-9);
  Keyframe blank;
  EXPECT_EQ(medianDepth(scene.state.map, blank), 0.0);
}

}  // namespace
}  // namespace glide
