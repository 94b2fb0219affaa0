#include "mapping/local_mapper.h"

#include "support/mapped_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace glide {
namespace {

using test::smallCloud;
using test::SyntheticCloud;
using test::SyntheticCloudOptions;
using test::SyntheticTracker;
using test::SyntheticView;
using test::walk;

/// Feeds a walk through a cloud to a mapper and reads what it publishes.
class MappedWalk {
 public:
  MappedWalk(const SyntheticCloudOptions& cloud, const SyntheticTracker::Options& tracker)
      : cloud_(test::syntheticCamera(DistortionModel::radial_tangential), cloud),
        tracker_(&cloud_, tracker),
        published_(std::make_shared<const MapSnapshot>()),
        mapper_(Config{}, cloud_.camera(), &published_) {}

  void start() {
    mapper_.process(tracker_.start(&cloud_, walk(0), walk(1), 3.0), nullptr);
    at_ = 1.0;
  }
  void advance(int steps, double step_length, const std::atomic<bool>* interrupt) {
    for (int i = 0; i < steps; ++i) mapper_.process(next(step_length), interrupt);
  }
  NewKeyframe next(double step_length) {
    at_ += step_length;
    return tracker_.track(*map(), cloud_.look(walk(at_)), newest());
  }
  std::shared_ptr<const MapSnapshot> map() const { return published_.load(); }
  KeyframeId newest() const { return map()->keyframes().back().id; }
  double keyframeError() const { return tracker_.keyframeError(*map()); }
  double landmarkError() const { return tracker_.landmarkError(*map()); }

  SyntheticCloud cloud_;
  SyntheticTracker tracker_;
  Published<MapSnapshot> published_;
  LocalMapper mapper_;
  double at_ = 0.0;
};

SyntheticCloudOptions noisyCloud() {
  SyntheticCloudOptions options = smallCloud();
  options.noise_px = 0.5;
  options.flipped_bits = 12;
  return options;
}

SyntheticTracker::Options sloppyTracker() {
  SyntheticTracker::Options options;
  options.tracked_share = 0.7;
  options.mismatch_share = 0.02;
  options.pose_noise = 0.003;
  return options;
}

void expectConsistent(const MapSnapshot& map) {
  for (const auto& keyframe : map.keyframes()) {
    ASSERT_EQ(keyframe.landmarks.size(), keyframe.features->size());
    for (const LandmarkId id : keyframe.landmarks) {
      EXPECT_TRUE(id == kNoLandmark || map.landmark(id) != nullptr);
    }
  }
  for (const auto& landmark : map.landmarks()) {
    EXPECT_GE(landmark.observations.size(), 2U);
    for (const Observation& seen : landmark.observations) {
      const auto* keyframe = map.keyframe(seen.keyframe);
      ASSERT_NE(keyframe, nullptr);
      EXPECT_EQ(keyframe->landmarks[static_cast<std::size_t>(seen.feature)], landmark.id);
    }
  }
}

TEST(LocalMapper, GrowsAnExactMapFromExactViews) {
  MappedWalk walk(smallCloud(), {});
  walk.start();
  const std::size_t at_start = walk.map()->landmarks().size();
  walk.advance(8, 1.0, nullptr);
  EXPECT_GT(walk.map()->landmarks().size(), at_start * 3 / 2);
  EXPECT_LT(walk.keyframeError(), 1e-4);
  EXPECT_LT(walk.landmarkError(), 1e-3);
  expectConsistent(*walk.map());
}

TEST(LocalMapper, KeepsTheErrorSmallWithNoisyViewsAndASloppyTracker) {
  MappedWalk walk(noisyCloud(), sloppyTracker());
  walk.start();
  walk.advance(12, 1.0, nullptr);
  EXPECT_LT(walk.keyframeError(), 0.01);  // of a walk of 3 units, 5 units from the scene
  EXPECT_LT(walk.landmarkError(), 0.15);
  expectConsistent(*walk.map());
}

TEST(LocalMapper, HoldsEachCornerOnce) {
  MappedWalk walk(noisyCloud(), sloppyTracker());
  walk.start();
  walk.advance(10, 1.0, nullptr);
  std::set<int> corners;
  for (const auto& landmark : walk.map()->landmarks())
    corners.insert(walk.tracker_.cornerOf(landmark));
  const std::size_t duplicates = walk.map()->landmarks().size() - corners.size();
  EXPECT_LE(duplicates, corners.size() / 50);
}

/// Share of the observations that show another corner than the landmark's first one.
double mixedShare(const MappedWalk& walk) {
  int all = 0;
  int mixed = 0;
  const auto map = walk.map();
  for (const auto& landmark : map->landmarks()) {
    const int corner = walk.tracker_.cornerOf(landmark);
    for (const Observation& seen : landmark.observations) {
      MapSnapshot::LandmarkEntry alone;
      alone.observations = {seen};
      ++all;
      if (walk.tracker_.cornerOf(alone) != corner) ++mixed;
    }
  }
  return static_cast<double>(mixed) / all;
}

TEST(LocalMapper, MixesFewCornersOfARepetitiveTexture) {
  SyntheticCloudOptions options = noisyCloud();
  options.looks = 3;  // a hundred corners of a view look the same: geometry has to tell them apart
  MappedWalk walk(options, sloppyTracker());
  walk.start();
  walk.advance(8, 1.0, nullptr);
  EXPECT_LT(mixedShare(walk), 0.01);
  EXPECT_LT(walk.keyframeError(), 0.01);
}

TEST(LocalMapper, RetiresRedundantKeyframesAndKeepsTheirPoses) {
  SyntheticCloudOptions options = smallCloud();
  options.missed_share = 0.0;
  MappedWalk walk(options, {});
  walk.start();
  const NewKeyframe early = walk.next(0.1);
  walk.mapper_.process(early, nullptr);
  walk.advance(8, 0.1, nullptr);
  const auto map = walk.map();
  EXPECT_FALSE(map->retired().empty());
  EXPECT_LT(map->keyframes().size(), 8U);
  ASSERT_TRUE(map->T_cam_world(early.id).has_value());
  const SE3d T_expected = early.T_cam_ref * *map->T_cam_world(early.reference);
  EXPECT_LT(test::translationError(*map->T_cam_world(early.id), T_expected), 1e-3);
}

TEST(LocalMapper, GivesTheSameMapTwice) {
  std::vector<std::shared_ptr<const MapSnapshot>> maps;
  for (int run = 0; run < 2; ++run) {
    MappedWalk walk(noisyCloud(), sloppyTracker());
    walk.start();
    walk.advance(6, 0.5, nullptr);
    maps.push_back(walk.map());
  }
  ASSERT_EQ(maps[0]->keyframes().size(), maps[1]->keyframes().size());
  ASSERT_EQ(maps[0]->landmarks().size(), maps[1]->landmarks().size());
  for (std::size_t i = 0; i < maps[0]->keyframes().size(); ++i) {
    EXPECT_EQ(maps[0]->keyframes()[i].T_cam_world.t, maps[1]->keyframes()[i].T_cam_world.t);
  }
  for (std::size_t i = 0; i < maps[0]->landmarks().size(); ++i) {
    EXPECT_EQ(maps[0]->landmarks()[i].id, maps[1]->landmarks()[i].id);
    EXPECT_EQ(maps[0]->landmarks()[i].p_world, maps[1]->landmarks()[i].p_world);
  }
}

TEST(LocalMapper, PublishesAscendingRevisions) {
  MappedWalk walk(smallCloud(), {});
  EXPECT_EQ(walk.map()->revision(), 0U);
  walk.start();
  const std::uint64_t at_start = walk.map()->revision();
  walk.advance(1, 1.0, nullptr);
  EXPECT_EQ(walk.map()->revision(), at_start + 2);  // before and after the adjustment
}

TEST(LocalMapper, SurvivesABlankKeyframe) {
  MappedWalk walk(smallCloud(), {});
  walk.start();
  NewKeyframe blank = walk.next(0.5);
  blank.features = std::make_shared<FeatureSet>();
  blank.landmarks.clear();
  walk.mapper_.process(blank, nullptr);
  EXPECT_EQ(walk.map()->keyframes().size(), 2U);
  EXPECT_TRUE(walk.map()->T_cam_world(blank.id).has_value());
  walk.advance(2, 0.5, nullptr);
  EXPECT_EQ(walk.map()->keyframes().size(), 4U);
  EXPECT_LT(walk.keyframeError(), 1e-3);
}

TEST(LocalMapper, StaysConsistentWhenInterrupted) {
  const std::atomic<bool> interrupt{true};
  MappedWalk walk(noisyCloud(), sloppyTracker());
  walk.start();
  const std::size_t at_start = walk.map()->landmarks().size();
  walk.advance(6, 1.0, &interrupt);
  EXPECT_GT(walk.map()->landmarks().size(), at_start);
  EXPECT_LT(walk.keyframeError(), 0.03);
  expectConsistent(*walk.map());
}

TEST(LocalMapper, StartsOverAndIgnoresKeyframesOfTheOldMap) {
  MappedWalk walk(smallCloud(), {});
  walk.start();
  walk.advance(3, 1.0, nullptr);
  NewKeyframe late = walk.next(1.0);
  const LandmarkId last_old = walk.map()->landmarks().back().id;
  walk.start();
  EXPECT_EQ(walk.map()->keyframes().size(), 2U);
  EXPECT_TRUE(walk.map()->retired().empty());
  EXPECT_LT(last_old, walk.map()->landmarks().front().id);
  late.id = KeyframeId{walk.newest().value + 1};
  walk.mapper_.process(late, nullptr);
  EXPECT_EQ(walk.map()->keyframes().size(), 2U);
}

TEST(LocalMapper, CullsLandmarksThatTrackingNeverFinds) {
  MappedWalk walk(smallCloud(), {});
  walk.start();
  std::set<LandmarkId> at_start;
  for (const auto& landmark : walk.map()->landmarks()) at_start.insert(landmark.id);
  walk.advance(1, 2.0, nullptr);
  std::vector<LandmarkId> fresh;
  for (const auto& landmark : walk.map()->landmarks()) {
    if (at_start.count(landmark.id) == 0) fresh.push_back(landmark.id);
  }
  ASSERT_GT(fresh.size(), 10U);
  NewKeyframe message = walk.next(1.0);
  message.sightings.clear();
  for (const LandmarkId id : fresh) message.sightings.push_back({id, 20, 0});
  walk.mapper_.process(message, nullptr);
  for (const LandmarkId id : fresh) EXPECT_EQ(walk.map()->landmark(id), nullptr);
}

}  // namespace
}  // namespace glide
