#include "map/map_correction.h"

#include "support/true_map.h"

#include "map/map_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

namespace glide {
namespace {

constexpr int kSteps = 8;
// A similarity that no part of the code can take for the identity.
const Vec7d kTangent = (Vec7d() << 0.5, -0.3, 0.2, 0.1, -0.2, 0.05, 0.3).finished();

Sim3d part(double share) { return Sim3d::exp(share * kTangent); }

test::SyntheticCloudOptions sparseCloud() {
  test::SyntheticCloudOptions options;
  options.points = 800;
  return options;
}

LoopCorrection moving(std::vector<KeyframeMove> keyframes) {
  LoopCorrection correction;
  correction.keyframes = std::move(keyframes);
  return correction;
}

LoopCorrection fusing(std::vector<LoopCorrection::SamePoint> same) {
  LoopCorrection correction;
  correction.same = std::move(same);
  return correction;
}

LoopCorrection joining(KeyframeId newer, KeyframeId older) {
  LoopCorrection correction;
  correction.edge = {newer, older};
  return correction;
}

double distance(const SE3d& a, const SE3d& b) { return (a * b.inverse()).log().norm(); }

/// The true map of a walk along a cloud: keyframe i at 0.5 i, each seeing its landmarks exactly.
class MapCorrection : public testing::Test {
 protected:
  MapCorrection() {
    for (int i = 0; i < kSteps; ++i) {
      world_.addKeyframe(test::lookAlong(Vec3d(0.5 * i, 0.0, 0.0), 0.0));
    }
  }

  static std::vector<KeyframeMove> movesOf(int first, int last, const Sim3d& S_new_old) {
    std::vector<KeyframeMove> moves;
    for (int i = first; i <= last; ++i) moves.push_back({KeyframeId{std::uint64_t(i)}, S_new_old});
    return moves;
  }

  Vec3d inCamera(KeyframeId keyframe, LandmarkId landmark) const {
    return *map_.T_cam_world(keyframe) * map_.landmark(landmark)->p_world;
  }

  using Sights = std::map<std::pair<KeyframeId, LandmarkId>, Vec2d>;

  /// Where each landmark projects in the keyframes from `first` on that see it.
  Sights sights(KeyframeId first) const {
    Sights result;
    for (const LandmarkId id : map_.landmarkIds()) {
      for (const Observation& seen : map_.landmark(id)->observations) {
        if (seen.keyframe < first) continue;
        const auto uv = world_.cloud.camera().project(inCamera(seen.keyframe, id));
        result[{seen.keyframe, id}] = uv.value_or(Vec2d::Zero());
      }
    }
    return result;
  }

  static double worstChange(const Sights& before, const Sights& after) {
    EXPECT_EQ(before.size(), after.size());
    double worst = 0.0;
    for (const auto& [what, uv] : before) worst = std::max(worst, (uv - after.at(what)).norm());
    return worst;
  }

  test::TrueMap world_{sparseCloud()};
  Map& map_ = world_.map;
};

TEST_F(MapCorrection, ChangesNoImageWhenEverythingMovesAlike) {
  const Sights before = sights(KeyframeId{0});
  applyCorrection(moving(movesOf(0, kSteps - 1, part(1.0))), &map_);
  ASSERT_GT(before.size(), 500U);
  EXPECT_LT(worstChange(before, sights(KeyframeId{0})), 1e-9);
  EXPECT_NEAR(map_.keyframe(KeyframeId{3})->scale, part(1.0).s, 1e-12);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapCorrection, KeepsPosesRightThatWereTrackedRelativeToAKeyframe) {
  const KeyframeId reference{5};
  const SE3d T_cam_ref = SE3d::exp((Vec6d() << 0.1, 0.05, -0.1, 0.02, -0.03, 0.01).finished());
  const double scale_then = map_.keyframe(reference)->scale;
  const LandmarkId seen = map_.landmarkIds().back();
  const Vec2d uv = *world_.cloud.camera().project(T_cam_ref * inCamera(reference, seen));

  applyCorrection(moving(movesOf(0, kSteps - 1, part(1.0))), &map_);
  SE3d T_cam_ref_now = T_cam_ref;
  T_cam_ref_now.t *= map_.keyframe(reference)->scale / scale_then;
  const Vec2d uv_now = *world_.cloud.camera().project(T_cam_ref_now * inCamera(reference, seen));
  EXPECT_LT((uv - uv_now).norm(), 1e-9);
}

TEST_F(MapCorrection, TakesLandmarksAlongWithTheirFirstKeyframe) {
  std::map<LandmarkId, Vec3d> before;
  for (const LandmarkId id : map_.landmarkIds()) {
    before[id] = inCamera(map_.landmark(id)->observations.front().keyframe, id);
  }
  LoopCorrection correction;
  for (std::uint64_t i = 0; i < kSteps; ++i) {
    correction.keyframes.push_back({KeyframeId{i}, part(double(i) / kSteps)});
  }
  applyCorrection(correction, &map_);
  for (const auto& [id, p_cam] : before) {
    const Keyframe& first = *map_.keyframe(map_.landmark(id)->observations.front().keyframe);
    EXPECT_LT((inCamera(first.id, id) - first.scale * p_cam).norm(), 1e-9);
  }
  EXPECT_NEAR(map_.keyframe(KeyframeId{6})->scale, part(6.0 / kSteps).s, 1e-12);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapCorrection, MovesTheViewingRangeWithTheScale) {
  const LandmarkId id = map_.landmarkIds().front();
  const Landmark before = *map_.landmark(id);
  applyCorrection(moving(movesOf(0, kSteps - 1, part(1.0))), &map_);
  const Landmark& after = *map_.landmark(id);
  EXPECT_NEAR(after.max_distance, part(1.0).s * before.max_distance, 1e-9);
  EXPECT_NEAR(after.min_distance, part(1.0).s * before.min_distance, 1e-9);
  EXPECT_LT((after.normal - part(1.0).q * before.normal).norm(), 1e-9);
}

TEST_F(MapCorrection, TakesAlongWhatIsNewer) {
  const SE3d T_7_4 = *map_.T_cam_world(KeyframeId{7}) * map_.T_cam_world(KeyframeId{4})->inverse();
  const Sights before = sights(KeyframeId{5});
  LoopCorrection correction = moving(movesOf(0, 3, Sim3d{}));
  correction.keyframes.push_back({KeyframeId{4}, part(1.0)});
  applyCorrection(correction, &map_);

  // 5 follows 4, its best neighbour, and 6 and 7 follow 5.
  const SE3d T_7_4_now =
      *map_.T_cam_world(KeyframeId{7}) * map_.T_cam_world(KeyframeId{4})->inverse();
  SE3d T_expected = T_7_4;
  T_expected.t *= part(1.0).s;
  EXPECT_LT(distance(T_7_4_now, T_expected), 1e-9);
  EXPECT_NEAR(map_.keyframe(KeyframeId{7})->scale, part(1.0).s, 1e-12);

  // What only the moved ones see stays where it was in their images.
  const Sights after = sights(KeyframeId{5});
  int newer = 0;
  for (const auto& [what, uv] : before) {
    if (map_.landmark(what.second)->observations.front().keyframe < KeyframeId{4}) continue;
    ++newer;
    EXPECT_LT((uv - after.at(what)).norm(), 1e-9);
  }
  EXPECT_GT(newer, 10);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapCorrection, TakesAlongAKeyframeThatSharesNothing) {
  // Looks away.
  const KeyframeId alone = world_.addKeyframe(test::lookAlong(Vec3d(0.0, 0.0, -500.0), 3.1));
  ASSERT_TRUE(map_.covisibility().neighbors(alone, 1).empty());
  applyCorrection(moving(movesOf(0, kSteps - 1, part(1.0))), &map_);
  EXPECT_NEAR(map_.keyframe(alone)->scale, part(1.0).s, 1e-12);
}

TEST_F(MapCorrection, PassesOverKeyframesThatWereRetiredMeanwhile) {
  const KeyframeId retired{3};
  const KeyframeId other{6};
  ASSERT_TRUE(map_.retireKeyframe(retired));
  const KeyframeId parent = map_.retired().at(retired).parent;
  const SE3d T_before = *map_.T_cam_world(retired) * map_.T_cam_world(parent)->inverse();
  LoopCorrection correction = moving(movesOf(0, kSteps - 1, part(1.0)));
  correction.edge = {other, retired};
  correction.keyframes[3].S_new_old = part(-2.0);
  applyCorrection(correction, &map_);

  SE3d T_expected = T_before;
  T_expected.t *= part(1.0).s;
  EXPECT_LT(distance(*map_.T_cam_world(retired) * map_.T_cam_world(parent)->inverse(), T_expected),
            1e-9);
  ASSERT_EQ(map_.loops().size(), 1U);
  EXPECT_EQ(map_.loops()[0].newer, other);
  EXPECT_EQ(map_.loops()[0].older, parent);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapCorrection, ForgetsAnEdgeThatLeadsNowhere) {
  const KeyframeId retired{3};
  ASSERT_TRUE(map_.retireKeyframe(retired));
  applyCorrection(joining(map_.retired().at(retired).parent, retired), &map_);
  applyCorrection(joining(KeyframeId{99}, KeyframeId{0}), &map_);
  EXPECT_TRUE(map_.loops().empty());
}

TEST_F(MapCorrection, ChangesNothingThatItDoesNotName) {
  const Sights before = sights(KeyframeId{0});
  const SE3d T_before = *map_.T_cam_world(KeyframeId{2});
  applyCorrection(moving(movesOf(50, 60, part(1.0))), &map_);
  EXPECT_EQ(map_.T_cam_world(KeyframeId{2})->t, T_before.t);
  EXPECT_EQ(worstChange(before, sights(KeyframeId{0})), 0.0);
}

/// Landmarks of the same place under two names: what the loop's ends see.
class MapFusion : public MapCorrection {
 protected:
  MapFusion() {
    const std::vector<LandmarkId> ids = map_.landmarkIds();
    std::copy(ids.begin(), ids.begin() + 4, name_);
  }
  LandmarkId name_[4];
};

TEST_F(MapFusion, FollowsChainsInAnyOrder) {
  const std::size_t before = map_.landmarkCount();
  applyCorrection(fusing({{name_[1], name_[2]}, {name_[0], name_[1]}, {name_[2], name_[3]}}),
                  &map_);
  EXPECT_EQ(map_.landmarkCount(), before - 3);
  EXPECT_NE(map_.landmark(name_[3]), nullptr);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapFusion, CountsACircleOnce) {
  const std::size_t before = map_.landmarkCount();
  applyCorrection(fusing({{name_[0], name_[1]}, {name_[1], name_[0]}, {name_[2], name_[2]}}),
                  &map_);
  EXPECT_EQ(map_.landmarkCount(), before - 1);
  EXPECT_NE(map_.landmark(name_[1]), nullptr);
  EXPECT_EQ(checkConsistency(map_), "");
}

TEST_F(MapFusion, PassesOverLandmarksThatAreGone) {
  map_.removeLandmark(name_[1]);
  map_.removeLandmark(name_[3]);
  const std::size_t before = map_.landmarkCount();
  // 0 and 2 are the same although the one between them and the one to keep are gone.
  applyCorrection(fusing({{name_[0], name_[1]}, {name_[1], name_[2]}, {name_[2], name_[3]}}),
                  &map_);
  EXPECT_EQ(map_.landmarkCount(), before - 1);
  applyCorrection(fusing({{LandmarkId{9999}, name_[0]}, {name_[0], LandmarkId{8888}}}), &map_);
  EXPECT_EQ(map_.landmarkCount(), before - 1);
  EXPECT_EQ(checkConsistency(map_), "");
}

class MapAdjustment : public MapCorrection {};

TEST_F(MapAdjustment, PutsLandmarksWhereItSaysAndTakesTheNewerAlong) {
  const Sim3d S_rigid{so3Exp(Vec3d(0.1, -0.05, 0.2)), Vec3d(0.3, 0.2, -0.1), 1.0};
  const std::vector<LandmarkId> ids = map_.landmarkIds();
  const Sights before = sights(KeyframeId{0});
  std::map<LandmarkId, Vec3d> old;
  for (const LandmarkId id : ids) old[id] = map_.landmark(id)->p_world;

  GlobalAdjustment adjustment;
  adjustment.keyframes = movesOf(0, 5, S_rigid);
  const Vec3d offset(0.01, 0.02, 0.03);
  for (std::size_t i = 0; i < ids.size() / 2; ++i) {
    adjustment.landmarks.push_back({ids[i], S_rigid * old[ids[i]] + offset - old[ids[i]]});
  }
  adjustment.landmarks.push_back({LandmarkId{9999}, Vec3d::Zero()});
  applyAdjustment(adjustment, &map_);

  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Vec3d expected = S_rigid * old[ids[i]] + (i < ids.size() / 2 ? offset : Vec3d::Zero());
    EXPECT_LT((map_.landmark(ids[i])->p_world - expected).norm(), 1e-12);
  }
  const Sights after = sights(KeyframeId{0});
  for (const auto& [what, uv] : before) {
    if (what.second < ids[ids.size() / 2]) continue;
    EXPECT_LT((uv - after.at(what)).norm(), 1e-9);
  }
  EXPECT_EQ(map_.keyframe(KeyframeId{7})->scale, 1.0);
  EXPECT_EQ(checkConsistency(map_), "");
}

}  // namespace
}  // namespace glide
