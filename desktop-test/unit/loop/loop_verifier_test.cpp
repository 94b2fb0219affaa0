#include "loop/loop_verifier.h"

#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include "loop/keyframe_graph.h"
#include "loop/landmark_matching.h"
#include "loop/projected_search.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace glide {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr int kPerTurn = 60;
constexpr KeyframeId kOlder{4}, kNewer{kPerTurn + 4}, kElsewhere{kPerTurn / 2};

/// One turn and a bit, mapped once: tests only read it.
class LoopVerifierTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    map_ = std::make_unique<test::DriftedMap>(test::ringCloud(), lens(), 0.3 * test::someDrift());
    for (int i = 0; i < kPerTurn + 9; ++i) map_->add(test::ringPose(kTwoPi * i / kPerTurn));
    snapshot_ = map_->snapshot();
  }
  static void TearDownTestSuite() {
    map_.reset();
    snapshot_.reset();
  }
  static CameraModel lens() { return test::syntheticCamera(DistortionModel::radial_tangential); }
  static const MapSnapshot::KeyframeEntry& at(KeyframeId id) { return *snapshot_->keyframe(id); }

  static std::unique_ptr<test::DriftedMap> map_;
  static std::shared_ptr<const MapSnapshot> snapshot_;

  const ScaleLevels levels_{1.2, 8};
  const LoopVerifier verifier_{lens(), levels_};
};

std::unique_ptr<test::DriftedMap> LoopVerifierTest::map_;
std::shared_ptr<const MapSnapshot> LoopVerifierTest::snapshot_;

TEST_F(LoopVerifierTest, MeasuresRotationPositionAndScale) {
  const auto loop = verifier_.verify(at(kNewer), at(kOlder), *snapshot_);
  ASSERT_TRUE(loop.has_value());
  EXPECT_TRUE(isBeyondDoubt(*loop));
  const Sim3d truth = map_->trueSimilarity(kNewer, kOlder);
  EXPECT_LT(so3Log(loop->S_newer_older.q.conjugate() * truth.q).norm(), 0.01);
  EXPECT_LT((loop->S_newer_older.t - truth.t).norm(), 0.05);
  EXPECT_NEAR(loop->S_newer_older.s / truth.s, 1.0, 0.02);
}

TEST_F(LoopVerifierTest, MatchesFeaturesWithLandmarksOfTheSameCorner) {
  const auto loop = verifier_.verify(at(kNewer), at(kOlder), *snapshot_);
  ASSERT_TRUE(loop.has_value());
  for (const LandmarkMatch& match : loop->matches) {
    EXPECT_EQ(map_->cornerOf(kNewer, match.feature), map_->cornerOf(*match.landmark));
  }
}

TEST_F(LoopVerifierTest, FindsNothingBetweenDifferentPlaces) {
  EXPECT_FALSE(verifier_.verify(at(kNewer), at(kElsewhere), *snapshot_).has_value());
}

TEST_F(LoopVerifierTest, DoubtsWhatLacksAnyOfItsEvidence) {
  const auto loop = verifier_.verify(at(kNewer), at(kOlder), *snapshot_);
  ASSERT_TRUE(loop.has_value());
  LoopGeometry weak = *loop;
  weak.agreeing_share = 0.2;
  EXPECT_FALSE(isBeyondDoubt(weak));
  weak = *loop;
  weak.pairs = 15;
  EXPECT_FALSE(isBeyondDoubt(weak));
  weak = *loop;
  weak.matches.resize(30);
  EXPECT_FALSE(isBeyondDoubt(weak));
  weak = *loop;
  weak.cells = 3;
  EXPECT_FALSE(isBeyondDoubt(weak));
  weak = *loop;
  weak.share_newer = 0.05;
  EXPECT_FALSE(isBeyondDoubt(weak));
  weak = *loop;
  weak.share_older = 0.05;
  EXPECT_FALSE(isBeyondDoubt(weak));
}

TEST_F(LoopVerifierTest, LooksForLandmarksWhereAnAssumedCameraSeesThem) {
  const std::vector<KeyframeId> own{kOlder};
  const auto landmarks = landmarksOf(*snapshot_, own);
  const SE3d& T_cam_world = at(kOlder).T_cam_world;
  AssumedView view{*at(kOlder).features, Sim3d{T_cam_world.q, T_cam_world.t, 1.0}};
  const ProjectedSearchOptions options{.radius_px = 6.0};
  const ProjectedSearch found = searchProjected(lens(), levels_, view, landmarks, options);
  EXPECT_GE(found.expected, static_cast<int>(0.9 * static_cast<double>(landmarks.size())));
  EXPECT_GE(found.matches.size(), 0.8 * static_cast<double>(landmarks.size()));

  // The camera's unit of length does not matter: the same view at three times the size.
  view.S_cam_world = Sim3d{Eigen::Quaterniond::Identity(), Vec3d::Zero(), 3.0} * view.S_cam_world;
  const ProjectedSearch again = searchProjected(lens(), levels_, view, landmarks, options);
  EXPECT_EQ(again.expected, found.expected);
  EXPECT_EQ(again.matches.size(), found.matches.size());
}

TEST_F(LoopVerifierTest, MatchesByLookOnlyWhatIsDistinct) {
  const std::vector<KeyframeId> older = placeOf(at(kOlder), 5);
  auto landmarks = landmarksOf(*snapshot_, older);
  const auto matches = matchByLook(at(kNewer), *snapshot_, landmarks);
  ASSERT_GE(matches.size(), 20U);
  std::set<LandmarkId> used;
  for (const LandmarkMatch& match : matches) EXPECT_TRUE(used.insert(match.landmark->id).second);

  // The first one's twin far away makes it ambiguous, a twin beside it does not.
  MapSnapshot::LandmarkEntry twin = *matches.front().landmark;
  twin.p_world += Vec3d(5.0, 0.0, 0.0);
  landmarks.push_back(&twin);
  EXPECT_EQ(matchByLook(at(kNewer), *snapshot_, landmarks).size(), matches.size() - 1);
  twin.p_world = matches.front().landmark->p_world + Vec3d(0.01, 0.0, 0.0);
  EXPECT_EQ(matchByLook(at(kNewer), *snapshot_, landmarks).size(), matches.size());
}

}  // namespace
}  // namespace glide
