#include "loop/loop_closer.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include "loop/loop_verifier.h"

#include "map/map_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace glide {
namespace {

using test::DriftedMap;

constexpr double kTwoPi = 6.283185307179586;
constexpr int kPerTurn = 60;
constexpr int kTurnAndMore = kPerTurn + 10;

CameraModel lens() { return test::syntheticCamera(DistortionModel::radial_tangential); }

/// Walks until a loop is found, at most `count` keyframes.
std::optional<LoopCorrection> walkRing(DriftedMap* map, LoopCloser* closer, int count) {
  for (int i = 0; i < count; ++i) {
    const KeyframeId id = map->add(test::ringPose(kTwoPi * i / kPerTurn));
    if (i < kPerTurn / 2) continue;  // nothing to be found: saves the time
    auto loop = closer->close(id, *map->snapshot(), map->index(), nullptr);
    if (loop) return loop;
  }
  return std::nullopt;
}

struct ClosedRing {
  DriftedMap map{test::ringCloud(), lens(), test::someDrift()};
  std::optional<LoopCorrection> loop;

  ClosedRing() {
    LoopCloser closer(Config{}, lens());
    loop = walkRing(&map, &closer, kTurnAndMore);
  }
};

/// Asks about one keyframe again and again.
std::optional<LoopCorrection> closeAt(KeyframeId id,
                                      const DriftedMap& map,
                                      const std::atomic<bool>* cancel) {
  LoopCloser closer(Config{}, lens());
  constexpr int kEnough = 5;
  for (int i = 0; i < kEnough; ++i) {
    auto loop = closer.close(id, *map.snapshot(), map.index(), cancel);
    if (loop) return loop;
  }
  return std::nullopt;
}

TEST(LoopCloser, ClosesARingThatDrifted) {
  const ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  EXPECT_LT(ring.loop->edge.older.value, 8U);
  EXPECT_GT(ring.loop->edge.newer.value, 50U);
  EXPECT_GT(ring.map.error({}), 0.25);
  EXPECT_LT(ring.map.error(ring.loop->keyframes), 0.3 * ring.map.error({}));
}

TEST(LoopCloser, KeepsTheOldestKeyframeAndNamesAllInOrder) {
  const ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  const auto& moves = ring.loop->keyframes;
  ASSERT_EQ(moves.size(), ring.map.snapshot()->keyframes().size());
  EXPECT_LT(moves.front().S_new_old.log().norm(), 1e-12);
  for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_LT(moves[i - 1].id, moves[i].id);
}

TEST(LoopCloser, FusesLandmarksOfTheSameCorner) {
  const ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  const auto snapshot = ring.map.snapshot();
  int right = 0;
  for (const LoopCorrection::SamePoint& same : ring.loop->same) {
    const auto* gone = snapshot->landmark(same.gone);
    const auto* kept = snapshot->landmark(same.kept);
    ASSERT_TRUE(gone && kept);
    right += ring.map.cornerOf(*gone) == ring.map.cornerOf(*kept) ? 1 : 0;
  }
  EXPECT_GE(ring.loop->same.size(), 30U);
  EXPECT_GE(right, static_cast<int>(0.97 * static_cast<double>(ring.loop->same.size())));
}

TEST(LoopCloser, GivesTheSameBitsAgain) {
  const ClosedRing first, second;
  ASSERT_TRUE(first.loop && second.loop);
  EXPECT_EQ(first.loop->edge.newer, second.loop->edge.newer);
  EXPECT_EQ(first.loop->same.size(), second.loop->same.size());
  ASSERT_EQ(first.loop->keyframes.size(), second.loop->keyframes.size());
  for (std::size_t i = 0; i < first.loop->keyframes.size(); ++i) {
    const Sim3d &a = first.loop->keyframes[i].S_new_old, &b = second.loop->keyframes[i].S_new_old;
    EXPECT_TRUE(a.t == b.t && a.q.coeffs() == b.q.coeffs() && a.s == b.s);
  }
}

TEST(LoopCloser, SeesNoLoopWhereOneIsClosed) {
  ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  ASSERT_TRUE(closeAt(ring.loop->edge.newer, ring.map, nullptr).has_value());
  applyCorrection(*ring.loop, ring.map.map());
  EXPECT_FALSE(closeAt(ring.loop->edge.newer, ring.map, nullptr).has_value());
}

TEST(LoopCloser, EndsEarlyWhenCancelled) {
  const ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  const std::atomic<bool> cancel{true};
  EXPECT_FALSE(closeAt(ring.loop->edge.newer, ring.map, &cancel).has_value());
}

TEST(LoopCloser, WantsSeveralKeyframesInARowToAgree) {
  const ClosedRing ring;
  ASSERT_TRUE(ring.loop.has_value());
  const auto snapshot = ring.map.snapshot();
  const KeyframeId id = ring.loop->edge.newer;
  LoopCloser closer(Config{}, lens());
  EXPECT_FALSE(closer.close(id, *snapshot, ring.map.index(), nullptr).has_value());
  closer.reset();
  EXPECT_FALSE(closer.close(id, *snapshot, ring.map.index(), nullptr).has_value());
  EXPECT_FALSE(closer.close(id, *snapshot, ring.map.index(), nullptr).has_value());
  EXPECT_TRUE(closer.close(id, *snapshot, ring.map.index(), nullptr).has_value());
}

TEST(LoopCloser, RefusesPlacesWhereAllLooksAlike) {
  test::SyntheticCloudOptions options = test::ringCloud();
  options.looks = 50;
  DriftedMap map(options, lens(), test::someDrift());
  LoopCloser closer(Config{}, lens());
  EXPECT_FALSE(walkRing(&map, &closer, kTurnAndMore).has_value());
}

TEST(LoopCloser, RefusesTheNextPeriodOfARepetitiveFront) {
  test::SyntheticCloudOptions options;
  options.points = 4000;
  options.high.x() = 34.0;
  options.repeat_x = 14.0;  // wider than a view
  DriftedMap map(options, lens(), 0.1 * test::someDrift());
  LoopCloser closer(Config{}, lens());
  constexpr int kKeyframes = 44, kPerPeriod = 24;
  for (int i = 0; i < kKeyframes; ++i) {
    const double x = options.repeat_x * i / kPerPeriod;
    const KeyframeId id = map.add(test::lookAlong(Vec3d(x, 0.0, 0.0), 0.0));
    EXPECT_FALSE(closer.close(id, *map.snapshot(), map.index(), nullptr).has_value()) << i;
  }
  // The periods do look alike: what refuses is how far off the map would have to be.
  const auto snapshot = map.snapshot();
  const LoopVerifier verifier(lens(), ScaleLevels(1.2, 8));
  const auto lookalike = verifier.verify(*snapshot->keyframe(KeyframeId{8 + kPerPeriod}),
                                         *snapshot->keyframe(KeyframeId{8}),
                                         *snapshot);
  ASSERT_TRUE(lookalike.has_value());
  EXPECT_TRUE(isBeyondDoubt(*lookalike));
}

/// Along a front, away from it for so long that the map may be off by any part of the front, and
/// back to where it began. Tells whether a loop was found.
bool comesBack(double repeat_x) {
  test::SyntheticCloudOptions options;
  options.points = 3500;
  options.high.x() = 28.0;
  options.repeat_x = repeat_x;
  DriftedMap map(options, lens(), 0.02 * test::someDrift());
  LoopCloser closer(Config{}, lens());
  constexpr double kStep = 0.6, kBack = 1.5;  // along the front, x of the return
  constexpr int kAlong = 35, kAway = 20, kAgain = 8;
  bool is_found = false;
  for (int i = 0; i < kAlong; ++i) map.add(test::lookAlong(Vec3d(kStep * i, 0.0, 0.0), 0.0));
  for (int i = 0; i < kAway; ++i) {  // looks at nothing
    const double z = -10.0 * std::min(i, kAway - i);
    map.add(test::lookAlong(Vec3d(kStep * (kAlong - i), 0.0, z), 3.1));
  }
  for (int i = 0; i < kAgain; ++i) {
    const KeyframeId id = map.add(test::lookAlong(Vec3d(kBack + kStep * i, 0.0, 0.0), 0.0));
    is_found |= closer.close(id, *map.snapshot(), map.index(), nullptr).has_value();
  }
  return is_found;
}

TEST(LoopCloser, RefusesAPlaceThatLooksAndFitsLikeAnother) {
  constexpr double kNever = 0.0, kPeriod = 14.0;
  EXPECT_TRUE(comesBack(kNever));
  EXPECT_FALSE(comesBack(kPeriod));
}

TEST(LoopCloser, IgnoresKeyframesThatAreGone) {
  const ClosedRing ring;
  LoopCloser closer(Config{}, lens());
  EXPECT_FALSE(
      closer.close(KeyframeId{777}, *ring.map.snapshot(), ring.map.index(), nullptr).has_value());
}

}  // namespace
}  // namespace glide
