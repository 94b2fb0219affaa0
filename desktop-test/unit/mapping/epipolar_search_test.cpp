#include "mapping/epipolar_search.h"

#include "support/synthetic_map.h"
#include "support/synthetic_problem.h"

#include "mapping/bearing_cache.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::lookAlong;
using test::SyntheticCloud;
using test::SyntheticCloudOptions;
using test::SyntheticView;

struct PairScore {
  int possible = 0, right = 0, wrong = 0;
};

class Pair {
 public:
  Pair(const CameraModel& camera, const SyntheticView& a, const SyntheticView& b)
      : camera_(camera), a_(a), b_(b) {
    free_a_.assign(a.points.size(), kNoLandmark);
    free_b_.assign(b.points.size(), kNoLandmark);
    bearings_a_ = bearingsOf(a);
    bearings_b_ = bearingsOf(b);
  }

  std::vector<Match> match(double min_parallax_rad) const {
    EpipolarOptions options;
    options.focal_px = 0.5 * (camera_.fx() + camera_.fy());
    options.min_parallax_rad = min_parallax_rad;
    const SE3d T_b_a = b_.T_cam_world * a_.T_cam_world.inverse();
    return matchAlongEpipolarPlanes({a_.features.get(), bearings_a_, free_a_},
                                    {b_.features.get(), bearings_b_, free_b_},
                                    T_b_a,
                                    options,
                                    ScaleLevels(1.2, 8));
  }

  PairScore score(double min_parallax_rad, const std::vector<Vec3d>& points) const {
    PairScore score;
    const Vec3d center_a = a_.T_cam_world.inverse().t;
    const Vec3d center_b = b_.T_cam_world.inverse().t;
    for (const int i : a_.points) {
      const bool in_b = std::find(b_.points.begin(), b_.points.end(), i) != b_.points.end();
      const Vec3d& p = points[static_cast<std::size_t>(i)];
      const double cosine = (p - center_a).normalized().dot((p - center_b).normalized());
      if (in_b && std::acos(cosine) > min_parallax_rad) ++score.possible;
    }
    for (const Match& match : match(min_parallax_rad)) {
      const bool is_right = a_.points[static_cast<std::size_t>(match.a)] ==
                            b_.points[static_cast<std::size_t>(match.b)];
      ++(is_right ? score.right : score.wrong);
    }
    return score;
  }

  std::vector<LandmarkId> free_a_, free_b_;

 private:
  std::vector<Vec3d> bearingsOf(const SyntheticView& view) const {
    BearingCache cache(camera_);
    Keyframe keyframe;
    keyframe.features = view.features;
    return cache.of(keyframe);
  }

  CameraModel camera_;
  SyntheticView a_, b_;
  std::vector<Vec3d> bearings_a_, bearings_b_;
};

class EpipolarSearchOn : public testing::TestWithParam<DistortionModel> {
 protected:
  PairScore scoreOf(const SE3d& T_a_world, const SE3d& T_b_world) {
    SyntheticCloudOptions options;
    options.noise_px = 0.5;
    options.flipped_bits = 10;
    SyntheticCloud cloud(test::syntheticCamera(GetParam()), options);
    const Pair pair(cloud.camera(), cloud.look(T_a_world), cloud.look(T_b_world));
    return pair.score(0.02, cloud.points());
  }
};

TEST_P(EpipolarSearchOn, FindsTheCommonCornersAfterAStepSideways) {
  const PairScore score =
      scoreOf(lookAlong(Vec3d::Zero(), 0.0), lookAlong(Vec3d(0.4, 0.05, 0.0), 0.1));
  EXPECT_GT(score.possible, 200);
  EXPECT_GE(score.right, score.possible * 9 / 10);
  EXPECT_EQ(score.wrong, 0);
}

TEST_P(EpipolarSearchOn, FindsTheCommonCornersAroundAnEpipoleInsideTheImage) {
  const PairScore score =
      scoreOf(lookAlong(Vec3d(0.0, 0.0, 0.6), 0.0), lookAlong(Vec3d(0.05, 0.0, 0.0), 0.02));
  EXPECT_GT(score.possible, 100);
  EXPECT_GE(score.right, score.possible * 9 / 10);
  EXPECT_EQ(score.wrong, 0);
}

TEST_P(EpipolarSearchOn, FollowsARollOfTheCamera) {
  SE3d T_b_world = lookAlong(Vec3d(0.4, 0.0, 0.0), 0.0);
  const SE3d T_roll{so3Exp(Vec3d(0.0, 0.0, 1.2)), Vec3d::Zero()};
  T_b_world = T_roll * T_b_world;
  const PairScore score = scoreOf(lookAlong(Vec3d::Zero(), 0.0), T_b_world);
  EXPECT_GT(score.possible, 100);
  EXPECT_GE(score.right, score.possible * 9 / 10);
  EXPECT_EQ(score.wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(AllLenses,
                         EpipolarSearchOn,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

class EpipolarSearch : public testing::Test {
 protected:
  SyntheticCloud cloud_{test::syntheticCamera(DistortionModel::none), {}};
  SyntheticView a_ = cloud_.look(lookAlong(Vec3d::Zero(), 0.0));
  SyntheticView b_ = cloud_.look(lookAlong(Vec3d(0.4, 0.0, 0.0), 0.0));
};

TEST_F(EpipolarSearch, LeavesFeaturesThatHaveALandmarkAlone) {
  Pair pair(cloud_.camera(), a_, b_);
  const std::vector<Match> all = pair.match(0.0);
  ASSERT_GT(all.size(), 20U);
  pair.free_a_[static_cast<std::size_t>(all[0].a)] = LandmarkId{1};
  pair.free_b_[static_cast<std::size_t>(all[1].b)] = LandmarkId{2};
  const std::vector<Match> fewer = pair.match(0.0);
  EXPECT_EQ(fewer.size(), all.size() - 2);
}

TEST_F(EpipolarSearch, RefusesWhenAnotherCornerInThePlaneLooksTheSame) {
  // Every descriptor the same: only planes with a single candidate may match.
  const auto blank = [](const SyntheticView& view) {
    SyntheticView copy = view;
    std::vector<Descriptor> same(view.features->size());
    copy.features = std::make_shared<FeatureSet>(view.features->features(), same, 640, 480);
    return copy;
  };
  const Pair distinct(cloud_.camera(), a_, b_);
  const Pair ambiguous(cloud_.camera(), blank(a_), blank(b_));
  EXPECT_LT(ambiguous.match(0.0).size(), distinct.match(0.0).size() / 2);
}

TEST_F(EpipolarSearch, FindsNothingBelowTheParallaxOrWithoutMotion) {
  const Pair pair(cloud_.camera(), a_, b_);
  EXPECT_TRUE(pair.match(0.5).empty());  // 0.4 units over 3 are 0.13 rad
  const Pair still(cloud_.camera(), a_, a_);
  EXPECT_TRUE(still.match(0.0).empty());
}

}  // namespace
}  // namespace glide
