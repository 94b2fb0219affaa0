#include "mapping/fusion.h"

#include "support/mapped_scene.h"

#include "mapping/new_landmarks.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

#include <set>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::walk;

class FusionTest : public testing::Test {
 protected:
  FusionTest() : scene_(smallCloud(), {}) {
    scene_.start();
    for (int step = 2; step < 6; ++step) {
      createLandmarks(&scene_.state, scene_.insert(walk(step)), nullptr);
    }
  }

  Map& map() { return scene_.state.map; }

  // Landmarks seen by the newest and at least three other keyframes.
  std::vector<LandmarkId> wellSeen() {
    std::vector<LandmarkId> result;
    for (const LandmarkId id : map().landmarkIds()) {
      const std::vector<Observation>& seen = map().landmark(id)->observations;
      if (seen.size() >= 4 && seen.back().keyframe == scene_.newest()) result.push_back(id);
    }
    return result;
  }

  std::size_t duplicates() {
    std::set<int> corners;
    const auto snapshot = scene_.map();
    for (const auto& landmark : snapshot->landmarks())
      corners.insert(scene_.tracker.cornerOf(landmark));
    return snapshot->landmarks().size() - corners.size();
  }

  MappedScene scene_;
};

TEST_F(FusionTest, MergesTwinsOfOneCorner) {
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  const std::size_t before = duplicates();
  int split = 0;
  for (const LandmarkId id : wellSeen()) {
    const Landmark original = *map().landmark(id);
    const LandmarkId twin = map().addLandmark(original.p_world, original.first_keyframe);
    for (std::size_t i = 0; i < 2; ++i) {
      map().removeObservation(id, original.observations[i].keyframe);
      map().addObservation(twin, original.observations[i]);
    }
    ++split;
  }
  map().refreshChanged();
  ASSERT_GT(split, 30);
  ASSERT_GE(duplicates(), before + static_cast<std::size_t>(split));
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  EXPECT_LE(duplicates(), before + static_cast<std::size_t>(split / 10));
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(FusionTest, AddsObservationsThatWereMissed) {
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  const std::vector<LandmarkId> forgotten = wellSeen();
  ASSERT_GT(forgotten.size(), 30U);
  for (const LandmarkId id : forgotten) map().removeObservation(id, scene_.newest());
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  std::size_t found = 0;
  for (const LandmarkId id : forgotten) {
    const Landmark* landmark = map().landmark(id);
    if (landmark != nullptr && landmark->observations.back().keyframe == scene_.newest()) ++found;
  }
  EXPECT_GE(found, forgotten.size() * 9 / 10);
  EXPECT_EQ(checkConsistency(map()), "");
}

TEST_F(FusionTest, NeverMixesTwoCorners) {
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  const auto snapshot = scene_.map();
  for (const auto& landmark : snapshot->landmarks()) {
    const int corner = scene_.tracker.cornerOf(landmark);
    for (const Observation& observation : landmark.observations) {
      MapSnapshot::LandmarkEntry single;
      single.observations = {observation};
      EXPECT_EQ(scene_.tracker.cornerOf(single), corner);
    }
  }
}

TEST_F(FusionTest, KeepsLandmarksApartThatOneImageShowsApart) {
  const std::vector<LandmarkId> ids = wellSeen();
  ASSERT_GE(ids.size(), 2U);
  // Two corners claimed to be at one place with one look, but seen at different pixels.
  Map& map = this->map();
  const std::size_t before = map.landmarkCount();
  map.setPosition(ids[1], map.landmark(ids[0])->p_world);
  fuseAround(&scene_.state, scene_.newest(), nullptr);
  EXPECT_NE(map.landmark(ids[0]), nullptr);
  EXPECT_NE(map.landmark(ids[1]), nullptr);
  EXPECT_GE(map.landmarkCount() + 20, before);
}

}  // namespace
}  // namespace glide
